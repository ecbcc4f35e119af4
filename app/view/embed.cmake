# Writes OUTPUT, the source that holds the files of the page. Run by the build with SOURCE_DIR, the folder they are in.
set(arrays "")
set(table "")
foreach(file "/ html index.html" "/viewer.css css viewer.css" "/viewer.js javascript viewer.js")
  separate_arguments(file)
  list(GET file 0 path)
  list(GET file 1 type)
  list(GET file 2 name)
  string(MAKE_C_IDENTIFIER "${name}" identifier)
  file(READ "${SOURCE_DIR}/${name}" bytes HEX)
  string(LENGTH "${bytes}" length)
  math(EXPR length "${length} / 2")
  string(REGEX REPLACE "(..)" "'\\\\x\\1'," bytes "${bytes}")
  string(APPEND arrays "constexpr char ${identifier}[] = {${bytes}};\n")
  string(APPEND table "    {\"${path}\", \"text/${type}; charset=utf-8\", {${identifier}, ${length}}},\n")
endforeach()
file(WRITE "${OUTPUT}" "// Made from assets/viewer by app/view/embed.cmake.
#include \"app/view/viewer_page.h\"

namespace bedmix {

namespace {

${arrays}
constexpr PageFile files[] = {
${table}};

}  // namespace

std::span<const PageFile> viewerPage() { return files; }

}  // namespace bedmix
")
