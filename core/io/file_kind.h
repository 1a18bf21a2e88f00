#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace plateau {

enum class FileFormat : unsigned char { Table, Ply, Off, Obj, Pcd, Npy };

/// What a file that is no point file seems to be ("a PNG picture"), by its first bytes; nothing if it may be one.
std::optional<std::string_view> foreign_kind(std::string_view bytes);

/// The format by content and, where content does not tell, by the name's extension (lower case, without the point).
FileFormat detect_format(std::string_view bytes, std::string_view extension);

/// Length of the first word of an OFF file, such as "COFF", at the start of the line; 0 if there is none.
std::size_t off_keyword_length(std::string_view line);

}  // namespace plateau
