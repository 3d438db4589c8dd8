# Finds all third-party libraries. OpenImageIO, ODE, Highway, xxHash and libav are found by
# pkg-config, because their CMake packages are missing or broken on Debian 12. {fmt} is too, because
# its CMake package defines a macro for all its users that only Windows needs.
find_package(PkgConfig REQUIRED)
find_package(Imath REQUIRED)
find_package(yaml-cpp REQUIRED)
find_package(embree 3 QUIET)  # for the laboratory alone
find_package(TBB REQUIRED)
find_package(CLI11 REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(Threads REQUIRED)
pkg_check_modules(ODE REQUIRED IMPORTED_TARGET ode)
pkg_check_modules(HWY REQUIRED IMPORTED_TARGET libhwy)
pkg_check_modules(XXHASH REQUIRED IMPORTED_TARGET libxxhash)
pkg_check_modules(FMT REQUIRED IMPORTED_TARGET fmt)
pkg_check_modules(FLATBUFFERS REQUIRED IMPORTED_TARGET flatbuffers)
pkg_check_modules(OPENEXR REQUIRED IMPORTED_TARGET OpenEXR)
# Its -pthread (and that of Pango), which glibc does not need, would not fit the precompiled headers.
set_target_properties(PkgConfig::OPENEXR PROPERTIES INTERFACE_COMPILE_OPTIONS "")
pkg_check_modules(ZSTD REQUIRED IMPORTED_TARGET libzstd)
pkg_check_modules(PNG REQUIRED IMPORTED_TARGET libpng)
pkg_check_modules(OIIO REQUIRED IMPORTED_TARGET OpenImageIO)
pkg_check_modules(FREETYPE REQUIRED IMPORTED_TARGET freetype2)
pkg_check_modules(PANGO REQUIRED IMPORTED_TARGET pangocairo pangoft2)
set_target_properties(PkgConfig::PANGO PROPERTIES INTERFACE_COMPILE_OPTIONS "")
pkg_check_modules(RSVG REQUIRED IMPORTED_TARGET librsvg-2.0)
pkg_check_modules(EBUR128 REQUIRED IMPORTED_TARGET libebur128)
pkg_check_modules(LIBAV REQUIRED IMPORTED_TARGET libavformat libavcodec libavutil libswresample libswscale)
find_program(FLATC flatc REQUIRED)
