# Checks every shader with glslang and embeds the texts: shaders/<pass>.<stage>.glsl, shaders/*.glsl (included by
# others) and shaders/shared.h become umbrage::gpu::shaderSource(). A shader is checked as it stands and once more for
# each comment line "// variant: NAME VALUE, NAME VALUE" in it.
function(embed_shaders output)
  file(GLOB texts CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/shaders/*.glsl ${CMAKE_CURRENT_SOURCE_DIR}/shaders/*.h)
  set(stamps)
  foreach(text ${texts})
    get_filename_component(name ${text} NAME)
    if(name MATCHES "\\.(vert|geom|frag|comp)\\.glsl$")
      set(stage ${CMAKE_MATCH_1})
      set(stamp ${CMAKE_CURRENT_BINARY_DIR}/shaders/${name}.checked)
      set(check ${GLSLANG} -l -S ${stage} -I${CMAKE_CURRENT_SOURCE_DIR}/shaders)
      set(commands COMMAND ${check} ${text})
      file(STRINGS ${text} variants REGEX "^// variant: ")
      foreach(variant ${variants})
        string(REGEX REPLACE "^// variant: " "" define "${variant}")
        string(REGEX REPLACE ", *" ";" define "${define}")
        string(REGEX REPLACE "([A-Z_0-9]+) ([^;]+)" "-D\\1=\\2" define "${define}")
        list(APPEND commands COMMAND ${check} ${define} ${text})
      endforeach()
      add_custom_command(OUTPUT ${stamp} ${commands} COMMAND ${CMAKE_COMMAND} -E touch ${stamp}
        DEPENDS ${texts} COMMENT "Checking ${name}" VERBATIM)
      list(APPEND stamps ${stamp})
    endif()
  endforeach()
  add_custom_command(OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -DOUTPUT=${output} "-DTEXTS=${texts}" -P ${CMAKE_SOURCE_DIR}/cmake/embed.cmake
    DEPENDS ${texts} ${stamps} ${CMAKE_SOURCE_DIR}/cmake/embed.cmake COMMENT "Embedding shaders" VERBATIM)
endfunction()
