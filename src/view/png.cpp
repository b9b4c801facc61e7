// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "view/png.hpp"

#include <png.h>

#include <new>
#include <stdexcept>

namespace deburr::view {
namespace {

/// The simplified interface of libpng: it leaves by return values, not by longjmp.
png_image describe(const Picture& picture) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(picture.width);
  image.height = static_cast<png_uint_32>(picture.height);
  image.format = PNG_FORMAT_RGB;
  return image;
}

}  // namespace

std::string png_bytes(const Picture& picture) {
  if (picture.width < 1 || picture.height < 1 ||
      picture.rgb.size() !=
          3U * static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height)) {
    throw std::invalid_argument("a picture must have three bytes for each of its pixels");
  }
  png_image image = describe(picture);
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::string bytes(size, '\0');
  if (png_image_write_to_memory(&image, bytes.data(), &size, 0, picture.rgb.data(), 0, nullptr) ==
      0) {
    throw std::runtime_error(std::string("libpng: ") + static_cast<const char*>(image.message));
  }
  bytes.resize(size);
  return bytes;
}

}  // namespace deburr::view
