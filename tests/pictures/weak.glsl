// weak.glsl - imitates an inaccurate driver, for weak.sh: the error of each built-in function is a pseudorandom share
// of the largest error that Vulkan allows. GLSL 3.30 and ES 3.00 bound none of these errors. Source: Vulkan
// specification, 'Precision of GLSL.std.450 Instructions'.

#define PER_COMPONENT(f)                                                                                     \
    vec2 f(vec2 v) { return vec2(f(v.x), f(v.y)); }                                                          \
    vec3 f(vec3 v) { return vec3(f(v.x), f(v.y), f(v.z)); }                                                  \
    vec4 f(vec4 v) { return vec4(f(v.x), f(v.y), f(v.z), f(v.w)); }

const float UNIT = 1.1920929e-7; // one unit in the last place of 1.0

// A pseudorandom number from -1 to 1, which depends only on x.
float weakShare(float x)
{
    uint v = floatBitsToUint(x);
    v = (v ^ (v >> 16u)) * 0x7feb352du;
    v = (v ^ (v >> 15u)) * 0x846ca68bu;
    return float((v ^ (v >> 16u)) >> 8u) / 8388608.0 - 1.0;
}

float weakLog2(float x)
{
    float right = log2(x), most = x > 0.5 && x < 2.0 ? 4.7683716e-7 : 3.0 * UNIT * abs(right);
    return right + most * weakShare(x);
}

float weakSin(float x) { return sin(x) + 4.8828125e-4 * weakShare(x); }
float weakCos(float x) { return cos(x) + 4.8828125e-4 * weakShare(x + 1.0); }
float weakTan(float x) { return weakSin(x) / weakCos(x); }
float weakInversesqrt(float x) { return inversesqrt(x) * (1.0 + 2.0 * UNIT * weakShare(x)); }
float weakSqrt(float x) { return sqrt(x) * (1.0 + 4.5 * UNIT * weakShare(x)); }
float weakExp2(float x) { return exp2(x) * (1.0 + (3.0 + 2.0 * abs(x)) * UNIT * weakShare(x)); }
float weakExp(float x) { return exp(x) * (1.0 + (3.0 + 2.0 * abs(x)) * UNIT * weakShare(x)); }
float weakLog(float x) { return 0.6931472 * weakLog2(x); }
float weakAtan(float y, float x) { return atan(y, x) * (1.0 + 4096.0 * UNIT * weakShare(y + 0.7 * x)); }
float weakAtan(float x) { return weakAtan(x, 1.0); }
float weakAsin(float x) { return weakAtan(x, weakSqrt(1.0 - x * x)); }
float weakAcos(float x) { return weakAtan(weakSqrt(1.0 - x * x), x); }
float weakPow(float x, float y) { return x > 0.0 ? weakExp2(y * weakLog2(x)) : 0.0; }

PER_COMPONENT(weakSin)
PER_COMPONENT(weakCos)
PER_COMPONENT(weakTan)
PER_COMPONENT(weakInversesqrt)
PER_COMPONENT(weakSqrt)
PER_COMPONENT(weakExp2)
PER_COMPONENT(weakExp)
PER_COMPONENT(weakLog2)
PER_COMPONENT(weakLog)
PER_COMPONENT(weakAtan)
PER_COMPONENT(weakAsin)
PER_COMPONENT(weakAcos)

vec2 weakPow(vec2 v, vec2 y) { return vec2(weakPow(v.x, y.x), weakPow(v.y, y.y)); }
vec3 weakPow(vec3 v, vec3 y) { return vec3(weakPow(v.xy, y.xy), weakPow(v.z, y.z)); }
vec4 weakPow(vec4 v, vec4 y) { return vec4(weakPow(v.xy, y.xy), weakPow(v.zw, y.zw)); }

float weakLength(float x) { return abs(x); }
float weakLength(vec2 v) { return weakSqrt(dot(v, v)); }
float weakLength(vec3 v) { return weakSqrt(dot(v, v)); }
float weakLength(vec4 v) { return weakSqrt(dot(v, v)); }
vec2  weakNormalize(vec2 v) { return v * weakInversesqrt(dot(v, v)); }
vec3  weakNormalize(vec3 v) { return v * weakInversesqrt(dot(v, v)); }
vec4  weakNormalize(vec4 v) { return v * weakInversesqrt(dot(v, v)); }

#define sin weakSin
#define cos weakCos
#define tan weakTan
#define asin weakAsin
#define acos weakAcos
#define atan weakAtan
#define exp weakExp
#define exp2 weakExp2
#define log weakLog
#define log2 weakLog2
#define pow weakPow
#define sqrt weakSqrt
#define inversesqrt weakInversesqrt
#define length weakLength
#define normalize weakNormalize
