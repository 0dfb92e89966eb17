# The window's fonts lie beside the programs (build/share/pixelscope/fonts). A missing one is no error: the window then
# uses Dear ImGui's own font.

set(PIXELSCOPE_FONT_DIR ${CMAKE_BINARY_DIR}/share/pixelscope/fonts)
set(PIXELSCOPE_INTER /usr/share/fonts/opentype/inter CACHE PATH "Folder of Inter's .otf files")
set(PIXELSCOPE_JETBRAINS /usr/share/fonts/truetype/jetbrains-mono CACHE PATH "Folder of JetBrains Mono's .ttf files")

if(PIXELSCOPE_GUI)
  foreach(font ${PIXELSCOPE_INTER}/Inter-Regular.otf ${PIXELSCOPE_INTER}/Inter-SemiBold.otf
               ${PIXELSCOPE_INTER}/Inter-Italic.otf ${PIXELSCOPE_INTER}/Inter-SemiBoldItalic.otf
               ${PIXELSCOPE_JETBRAINS}/JetBrainsMono-Regular.ttf
               ${PIXELSCOPE_JETBRAINS}/JetBrainsMono-Bold.ttf)
    if(EXISTS ${font})
      file(COPY ${font} DESTINATION ${PIXELSCOPE_FONT_DIR})
    else()
      message(WARNING "${font} is missing (Debian: fonts-inter, fonts-jetbrains-mono); "
                      "the window will use Dear ImGui's own font in its place.")
    endif()
  endforeach()
endif()
