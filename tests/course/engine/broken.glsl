const float two = 2.0;
const vec2 wrong = 1.0 +;
