# cmake -DFOLDER=... -DOUT=... -P embed.cmake: the page's files as strings of C++.
set(text "// Made from report.html, report.css and report.js by embed.cmake.\n#include \"tools/report/page.h\"\n\nnamespace alidade {\n")
foreach(ending Html Css Js)
  string(TOLOWER ${ending} lower)
  file(READ ${FOLDER}/report.${lower} content)
  string(APPEND text "extern const std::string_view kReport${ending} = R\"embedded(${content})embedded\";\n")
endforeach()
file(WRITE ${OUT} "${text}}  // namespace alidade\n")
