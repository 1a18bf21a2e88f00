#include "io/file_kind.h"

#include <array>
#include <vector>

#include "io/npy_header.h"
#include "io/pcd_header.h"
#include "io/text.h"

namespace plateau {
namespace {

using namespace std::string_view_literals;

struct Magic {
    std::string_view bytes;
    std::string_view kind;
};

constexpr std::array kMagics = {
    Magic{"\x89PNG"sv, "a PNG picture"},
    Magic{"\xFF\xD8\xFF"sv, "a JPEG picture"},
    Magic{"GIF8"sv, "a GIF picture"},
    Magic{"RIFF"sv, "a RIFF media file"},
    Magic{"PK\x03\x04"sv, "a zip archive (or an office document); unpack it first"},
    Magic{"PK\x05\x06"sv, "an empty zip archive"},
    Magic{"\x1F\x8B"sv, "gzip-compressed data; unpack it first"},
    Magic{"BZh"sv, "bzip2-compressed data; unpack it first"},
    Magic{"\xFD\x37zXZ\x00"sv, "xz-compressed data; unpack it first"},
    Magic{"\x28\xB5\x2F\xFD"sv, "zstd-compressed data; unpack it first"},
    Magic{"%PDF"sv, "a PDF document"},
    Magic{"\x7F"
          "ELF"sv,
          "a program"},
    Magic{"\0asm"sv, "a WebAssembly module"},
    Magic{"\x89HDF"sv, "an HDF5 file"},
    Magic{"glTF"sv, "a glTF scene"},
    Magic{"LASF"sv, "a LAS laser scan; convert it to PLY or text first"},
    Magic{"# vtk"sv, "a VTK file; convert it to PLY or text first"},
    Magic{"solid "sv, "an STL mesh; convert it to PLY, OFF or OBJ first"},
    Magic{"\xFF\xFE"sv, "UTF-16 text; save it as UTF-8"},
    Magic{"\xFE\xFF"sv, "UTF-16 text; save it as UTF-8"},
};

bool is_ply(std::string_view bytes) {
    return bytes.starts_with("ply") && bytes.size() > 3 && (bytes[3] == '\n' || bytes[3] == '\r' || bytes[3] == ' ');
}

/// A line "v" with at least two numbers among the first ones.
bool has_obj_vertex(std::string_view bytes) {
    constexpr std::uint64_t kLinesToLookAt = 1000;
    LineScanner lines(bytes);
    std::vector<std::string_view> fields;
    while (const auto line = lines.next()) {
        if (lines.line_number() > kLinesToLookAt) return false;
        if (!line->starts_with("v ") && !line->starts_with("v\t")) continue;
        split_at_blanks(*line, fields);
        if (fields.size() >= 3 && parse_field(fields[1]).kind != FieldKind::NotNumber) return true;
    }
    return false;
}

}  // namespace

std::size_t off_keyword_length(std::string_view line) {
    std::size_t at = 0;
    for (const std::string_view prefix : {"ST"sv, "C"sv, "N"sv, "4"sv, "n"sv}) {
        if (line.substr(at).starts_with(prefix)) at += prefix.size();
    }
    if (!line.substr(at).starts_with("OFF")) return 0;
    at += 3;
    // Some writers put the counts right behind the word.
    const bool ends = at == line.size() || static_cast<unsigned char>(line[at]) <= ' ' || line[at] == '#' ||
                      (line[at] >= '0' && line[at] <= '9');
    return ends ? at : 0;
}

std::optional<std::string_view> foreign_kind(std::string_view bytes) {
    constexpr std::size_t kBytesToLookAt = 4096;
    for (const Magic& magic : kMagics) {
        if (bytes.starts_with(magic.bytes)) return magic.kind;
    }
    const std::string_view content = trimmed(bytes.substr(0, kBytesToLookAt));
    if (content.starts_with("<")) return "a web page or XML";
    if (content.starts_with("{") || content.starts_with("[")) return "JSON";
    const bool may_hold_zeros = is_ply(bytes) || begins_as_pcd(bytes) || begins_as_npy(bytes);
    if (!may_hold_zeros && bytes.substr(0, kBytesToLookAt).find('\0') != std::string_view::npos) return "binary data";
    return std::nullopt;
}

FileFormat detect_format(std::string_view bytes, std::string_view extension) {
    if (is_ply(bytes)) return FileFormat::Ply;
    if (begins_as_npy(bytes)) return FileFormat::Npy;
    if (begins_as_pcd(bytes)) return FileFormat::Pcd;
    if (extension == "ply") return FileFormat::Ply;
    if (extension == "npy") return FileFormat::Npy;
    if (extension == "pcd") return FileFormat::Pcd;
    if (extension == "off" || off_keyword_length(first_content_line(bytes)) > 0) return FileFormat::Off;
    if (extension == "obj") return FileFormat::Obj;
    const bool named_table = extension == "xyz" || extension == "txt" || extension == "csv";
    return !named_table && has_obj_vertex(bytes) ? FileFormat::Obj : FileFormat::Table;
}

}  // namespace plateau
