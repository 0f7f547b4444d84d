# Writes ${OUTPUT}: the texts as one C++ table. Run by the build (see shaders.cmake).
set(code "// Generated from renderer/shaders by cmake/embed.cmake.\n#include <map>\n#include <string_view>\n\n#include \"gpu/program.h\"\n\nnamespace umbrage::gpu {\n\nstd::string_view shaderSource(std::string_view name) {\n    static const std::map<std::string_view, std::string_view> kTexts = {\n")
foreach(text ${TEXTS})
  get_filename_component(name ${text} NAME)
  file(READ ${text} content)
  string(APPEND code "{\"${name}\", R\"__glsl__(${content})__glsl__\"},\n")
endforeach()
string(APPEND code "    };\n    return kTexts.at(name);\n}\n\n}  // namespace umbrage::gpu\n")
file(WRITE ${OUTPUT} "${code}")
