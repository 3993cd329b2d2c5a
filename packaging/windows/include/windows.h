// The system's windows.h, which Qt's OpenGL brings along, without its words for the memory of old: they are names here.
#pragma once
#pragma GCC system_header // as it would be without this file
#include_next <windows.h>

#undef near
#undef far
#undef NEAR
#undef FAR
#define NEAR
#define FAR
