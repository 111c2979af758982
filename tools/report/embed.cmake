# cmake -DFOLDER=... -DOUT=... -DHEADER=... -DFILES="kName=file;..." -P embed.cmake: files as strings of C++, which the header declares.
set(text "// Made from ${FILES} by embed.cmake.\n#include \"${HEADER}\"\n\nnamespace alidade {\n")
foreach(each ${FILES})
  string(REPLACE "=" ";" each "${each}")
  list(POP_FRONT each name file)
  file(READ ${FOLDER}/${file} content)
  string(APPEND text "extern const std::string_view ${name} = R\"embedded(${content})embedded\";\n")
endforeach()
file(WRITE ${OUT} "${text}}  // namespace alidade\n")
