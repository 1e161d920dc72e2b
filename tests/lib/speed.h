// speed.h - the cost of two shaders, whose frames are drawn in turn.
#ifndef TESTS_SPEED_H
#define TESTS_SPEED_H

// Print the process CPU time of frames and of cold starts of two shaders, from the arguments of
// `measure speed A.frag B.frag [WxH]`; FILE@X,Y,Z,PAN,TILT places the camera. Call this after
// gpu_open, with the driver's shader cache off. Returns an exit status.
int speed_print(int argc, char **argv);

#endif
