#include "window/full_screen.h"

#include "report.h"

static GLFWmonitor *monitor_below(GLFWwindow *handle)
{
    int count = 0, x = 0, y = 0, width = 0, height = 0;
    GLFWmonitor **monitors = glfwGetMonitors(&count);
    glfwGetWindowPos(handle, &x, &y);
    glfwGetWindowSize(handle, &width, &height);
    for (int i = 0; i < count; i++) {
        int left, top;
        glfwGetMonitorPos(monitors[i], &left, &top);
        const GLFWvidmode *mode = glfwGetVideoMode(monitors[i]);
        int right = x + width / 2 - left, down = y + height / 2 - top;
        if (mode != NULL && right >= 0 && right < mode->width && down >= 0 && down < mode->height)
            return monitors[i];
    }
    return glfwGetPrimaryMonitor();
}

void window_toggle_full_screen(struct window *window)
{
    GLFWwindow *handle = window->handle;
    int *rectangle = window->rectangle;
    if (glfwGetWindowMonitor(handle) != NULL) {
        glfwSetWindowMonitor(handle, NULL, rectangle[0], rectangle[1], rectangle[2], rectangle[3],
                             GLFW_DONT_CARE);
        return;
    }
    GLFWmonitor *monitor = monitor_below(handle);
    const GLFWvidmode *mode = monitor != NULL ? glfwGetVideoMode(monitor) : NULL;
    if (mode == NULL) {
        report("full screen: the window system reports no monitor");
        return;
    }
    glfwGetWindowPos(handle, &rectangle[0], &rectangle[1]);
    glfwGetWindowSize(handle, &rectangle[2], &rectangle[3]);
    glfwSetWindowMonitor(handle, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}
