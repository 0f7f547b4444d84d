# The libraries umbrage stands on, in one place (their Debian names are in packages.txt).
find_package(TinyGLTF REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(yaml-cpp REQUIRED)
find_package(glm REQUIRED)
find_package(fmt REQUIRED)
find_package(CLI11 REQUIRED)
find_package(Threads REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(epoxy REQUIRED IMPORTED_TARGET epoxy)
# Debian's CMake files for these two fail: OpenImageIO's wants OpenCV's headers, OpenColorIO's lies outside the search path.
pkg_check_modules(OpenImageIO REQUIRED IMPORTED_TARGET OpenImageIO)
pkg_check_modules(OpenColorIO REQUIRED IMPORTED_TARGET OpenColorIO)
find_program(GLSLANG glslangValidator REQUIRED)
