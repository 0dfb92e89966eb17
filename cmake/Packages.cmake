# Third-party libraries. A missing one stops the configuration; the scripts app/run and tests/run install them all.

find_package(Threads REQUIRED)
find_package(glm CONFIG REQUIRED)
find_package(fmt CONFIG REQUIRED)
find_package(nlohmann_json CONFIG REQUIRED)
find_package(tinyobjloader CONFIG REQUIRED)
find_package(hwy CONFIG REQUIRED)
find_package(CLI11 CONFIG REQUIRED)

find_path(PIXELSCOPE_STB stb/stb_image.h)  # included as <stb/stb_image.h>, only inside core/image
if(NOT PIXELSCOPE_STB)
  message(FATAL_ERROR "stb_image.h was not found; on Debian it is in libstb-dev.")
endif()

# OpenGL, for the renderer in core/hardware and for the window. On Debian: libepoxy-dev libegl-dev.
find_package(PkgConfig)
if(PkgConfig_FOUND)
  pkg_check_modules(epoxy QUIET IMPORTED_TARGET epoxy)
endif()
find_path(PIXELSCOPE_EGL EGL/egl.h)
if(TARGET PkgConfig::epoxy AND PIXELSCOPE_EGL)
  set(PIXELSCOPE_HAS_EGL ON)
else()
  set(PIXELSCOPE_HAS_EGL OFF)
endif()
option(PIXELSCOPE_HARDWARE "Build the renderer that draws with OpenGL (libepoxy and EGL)" ${PIXELSCOPE_HAS_EGL})
if(PIXELSCOPE_HARDWARE AND NOT PIXELSCOPE_HAS_EGL)
  message(FATAL_ERROR "PIXELSCOPE_HARDWARE needs libepoxy and EGL; on Debian they are in libepoxy-dev and libegl-dev.")
endif()

find_path(PIXELSCOPE_MD4C_INCLUDE md4c.h)
find_library(PIXELSCOPE_MD4C md4c)
if(NOT PIXELSCOPE_MD4C_INCLUDE OR NOT PIXELSCOPE_MD4C)
  message(FATAL_ERROR "md4c was not found; on Debian it is in libmd4c-dev.")
endif()

if(PIXELSCOPE_GUI)
  find_package(PkgConfig REQUIRED)
  find_package(SDL2 CONFIG REQUIRED)
  find_package(Freetype REQUIRED)
  pkg_check_modules(epoxy REQUIRED IMPORTED_TARGET epoxy)
  pkg_check_modules(imgui REQUIRED IMPORTED_TARGET imgui)
endif()

if(PIXELSCOPE_TESTS)
  find_package(GTest REQUIRED)
  find_package(rapidcheck CONFIG REQUIRED)
endif()

# An accelerator to choose, and what pixelscope-bench measures against, where it is installed.
find_library(PIXELSCOPE_EMBREE NAMES embree4 embree3)
