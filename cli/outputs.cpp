// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "outputs.hpp"

#include "console.hpp"
#include "deburr/error.hpp"
#include "interrupt.hpp"

namespace deburr::cli {

void Outputs::commit(std::string_view last) {
  // A single file that is new never needs another name, by which it could be left over.
  for (AtomicFile& file : files_) files_.size() > 1 ? file.finish() : file.sync();
  if (interrupted()) throw Cancelled();
  if (!last.empty()) print(last);
  // The last first: what was named first is what takes the place of an input, and that must not
  // have changed where another file cannot be put in its place.
  for (auto file = files_.rbegin(); file != files_.rend(); ++file) file->commit();
}

}  // namespace deburr::cli
