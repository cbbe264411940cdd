# cmake -D FOLDER=... -D OUT=... -P makePage.cmake
# Puts style and scripts into page.html, and makes a C++ source of it. Bytes and not a string literal:
# some compilers take only short ones.
file(READ ${FOLDER}/page.html page)
foreach(part page.css data.js tree.js pictures.js view.js input.js page.js)
  file(READ ${FOLDER}/${part} text)
  string(REPLACE "/* ${part} */" "${text}" page "${page}")
endforeach()
file(WRITE ${OUT}.html "${page}")
file(READ ${OUT}.html bytes HEX)
string(REGEX REPLACE "(..)" "0x\\1," bytes "${bytes}")
file(WRITE ${OUT}
  "#include \"app/explore/pageText.h\"\n"
  "static const unsigned char page[] = {${bytes}};\n"
  "std::string_view pageTemplate() {\n"
  "    return {reinterpret_cast<const char*>(page), sizeof page};\n"
  "}\n")
