# Writes a C++ source that holds a text: `text` is its file, may be empty; `source` is written.
if(text)
  file(READ "${text}" bytes HEX)
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${bytes}")
else()
  set(bytes "")
endif()
file(CONFIGURE OUTPUT "${source}" @ONLY CONTENT [[
#include "view/page.hpp"

namespace deburr::view {
namespace {
constexpr unsigned char text[] = {@bytes@0};
}

std::string_view viewer_template() {
  return {reinterpret_cast<const char*>(text), sizeof(text) - 1};
}

}  // namespace deburr::view
]])
