// CMake parses precompiled headers for a target, and a target has a source file.
