// page.js - the functions of page.h, for Emscripten's --js-library. The page may define onSize, onTitle,
// onCapture, onCursor, onPicture and keyLabel on the module.
mergeInto(LibraryManager.library, {
    page_open_context__deps: ['$GL'],
    page_open_context: function () {
        const handle = GL.createContext(Module['canvas'], {
            majorVersion: 2, minorVersion: 0, alpha: false, antialias: false, depth: false, stencil: false,
            premultipliedAlpha: true, preserveDrawingBuffer: false, powerPreference: 'high-performance',
            enableExtensionsByDefault: true
        });
        if (!handle) return 1;
        GL.makeContextCurrent(handle);
        Module['handle'] = handle;
        // Some phones can draw into half-float targets, but not into 32-bit ones.
        return GLctx.getExtension('EXT_color_buffer_float') || GLctx.getExtension('EXT_color_buffer_half_float') ? 0 : 2;
    },
    page_close_context__deps: ['$GL'],
    page_close_context: function () {
        if (Module['handle']) GL.deleteContext(Module['handle']);
        Module['handle'] = 0;
    },
    page_draws_copy: function (from, to, filter) {
        const gl = GLctx, rectangle = (at) => HEAP32.subarray(at >> 2, (at >> 2) + 4);
        const [left, bottom, right, top] = rectangle(from), [x, y, x2, y2] = rectangle(to);
        if (gl.getExtension('EXT_color_buffer_float')) return 0;
        if (!gl.isProgram(Module['copier'])) {
            const program = Module['copier'] = gl.createProgram();
            [[gl.VERTEX_SHADER, 'void main() { gl_Position = vec4(gl_VertexID == 1 ? 3 : -1, gl_VertexID == 2 ? 3 : -1, 0, 1); }'],
            [gl.FRAGMENT_SHADER, 'uniform highp sampler2D picture; uniform vec4 map; out vec4 colour; void main() { colour = texture(picture, (gl_FragCoord.xy * map.xy + map.zw) / vec2(textureSize(picture, 0))); }']].forEach(([kind, text]) => {
                const shader = gl.createShader(kind);
                gl.shaderSource(shader, `#version 300 es\nprecision highp float;\n${text}`);
                gl.compileShader(shader);
                gl.attachShader(program, shader);
                gl.deleteShader(shader);
            });
            gl.linkProgram(program);
        }
        const program = Module['copier'], across = (right - left) / (x2 - x), up = (top - bottom) / (y2 - y);
        gl.useProgram(program);
        gl.uniform4f(gl.getUniformLocation(program, 'map'), across, up, left - across * x, bottom - up * y);
        gl.bindVertexArray(null);
        gl.bindTexture(gl.TEXTURE_2D, gl.getFramebufferAttachmentParameter(gl.READ_FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.FRAMEBUFFER_ATTACHMENT_OBJECT_NAME));
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, filter);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, filter);
        gl.viewport(x, y, x2 - x, y2 - y);
        gl.drawArrays(gl.TRIANGLES, 0, 3);
        gl.bindTexture(gl.TEXTURE_2D, null);
        return 1;
    },
    page_has_threads: function () {
        return GLctx.getExtension('KHR_parallel_shader_compile') ? 1 : 0;
    },
    page_size: function (width, height) {
        if (Module['onSize']) Module['onSize'](width, height);
    },
    page_title: function (text) {
        if (Module['onTitle']) Module['onTitle'](UTF8ToString(text));
    },
    page_key_label: function (key, label, size) {
        stringToUTF8(Module['keyLabel'] ? Module['keyLabel'](key) : '', label, size);
    },
    page_capture: function (captured) {
        if (Module['onCapture']) Module['onCapture'](captured !== 0);
    },
    page_cursor: function (shape) {
        if (Module['onCursor']) Module['onCursor'](shape);
    },
    page_picture: function (pixel, width, height, name) {
        const picture = new ImageData(width, height);
        for (let i = 0; i < picture.data.length; i += 4, pixel += 3) {
            picture.data[i] = HEAPU8[pixel];
            picture.data[i + 1] = HEAPU8[pixel + 1];
            picture.data[i + 2] = HEAPU8[pixel + 2];
            picture.data[i + 3] = 255;
        }
        if (Module['onPicture']) Module['onPicture'](picture, UTF8ToString(name));
    }
});
