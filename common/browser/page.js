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
    page_blends_floats: function () {
        return GLctx.getExtension('EXT_float_blend') ? 1 : 0;
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
