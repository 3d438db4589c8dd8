// Empty source file: CMake compiles precompiled headers only for targets, and a target needs a
// source file.
