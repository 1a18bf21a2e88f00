#include "io/session_file.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "io/binary_number.h"
#include "io/binary_text.h"

namespace plateau {
namespace {

class SessionReader : public FormatReader {
public:
    SessionReader(std::string_view bytes, const SessionHeader& header, RowSink& points, MatrixSink& distances)
        : numbers_(bytes.substr(header.data_at)),
          has_distances_(header.has_distances),
          single_(header.single_precision),
          count_(header.count),
          dimension_(static_cast<std::uint32_t>(header.dimension)),
          points_(points),
          distances_(distances) {}

    Result<ReadStatus> advance(std::uint32_t rows) override {
        if (!begun_) {
            begun_ = true;
            if (auto error = begin()) return std::move(*error);
            return ReadStatus::More;
        }
        for (std::uint32_t k = 0; k < rows; ++k) {
            if (row_ == count_) return ReadStatus::Done;
            auto error = has_distances_ ? read_distances() : read_point();
            if (error) return std::move(*error);
            ++row_;
        }
        return ReadStatus::More;
    }

private:
    std::optional<Error> begin() {
        if (has_distances_) return distances_.begin(count_, single_);
        if (points_.columns_asked()) {
            return Error{ErrorCode::InvalidOption, "The points of a session have no columns to choose from."};
        }
        std::vector<std::uint32_t> all(dimension_);
        std::iota(all.begin(), all.end(), 0u);
        if (auto error = points_.choose(dimension_, all)) return error;
        points_.reserve(count_);
        return std::nullopt;
    }

    double next() {
        const NumberType type = single_ ? NumberType::Float32 : NumberType::Float64;
        const double number = decode_number(numbers_.data() + position_, type, ByteOrder::LittleEndian);
        position_ += byte_size(type);
        return number;
    }

    std::optional<Error> read_point() {
        const std::span<double> point = points_.point();
        for (double& coordinate : point) coordinate = next();
        return points_.add_point(point, "Point", row_ + 1);
    }

    std::optional<Error> read_distances() {
        for (std::uint64_t other = 0; other < row_; ++other) {
            const EntryPlace place{row_ + 1, other + 1, 0};
            const auto [a, b] = std::pair(static_cast<std::uint32_t>(row_), static_cast<std::uint32_t>(other));
            if (auto error = distances_.set_once(a, b, next(), place)) return error;
        }
        return std::nullopt;
    }

    std::string_view numbers_;
    bool has_distances_;
    bool single_;
    std::uint64_t count_;
    std::uint32_t dimension_;
    RowSink& points_;
    MatrixSink& distances_;
    bool begun_ = false;
    std::uint64_t row_ = 0;
    std::size_t position_ = 0;
};

bool fits_single(double number) {
    if (!(std::abs(number) <= double{std::numeric_limits<float>::max()})) return false;
    return double{static_cast<float>(number)} == number;
}

void append_numbers(std::string& bytes, std::span<const double> numbers, bool single) {
    for (const double number : numbers) {
        if (single) {
            append_f32(bytes, static_cast<float>(number), ByteOrder::LittleEndian);
        } else {
            append_f64(bytes, number, ByteOrder::LittleEndian);
        }
    }
}

}  // namespace

std::unique_ptr<FormatReader> make_session_reader(std::string_view bytes, const SessionHeader& header, RowSink& points,
                                                  MatrixSink& distances) {
    return std::make_unique<SessionReader>(bytes, header, points, distances);
}

std::string session_bytes(const PointCloud& cloud, const SavedRun& saved) {
    const bool has_distances = cloud.dimension == 0;
    const DistanceMatrix& matrix = cloud.distances;
    const std::span<const double> doubles = has_distances ? matrix.entries : cloud.coordinates;
    // What a matrix keeps in single precision stays so; the run would hold it otherwise.
    const bool single =
        has_distances ? matrix.entries.empty() : std::all_of(doubles.begin(), doubles.end(), fits_single);
    const char* precision = single ? " single\n" : " double\n";

    std::string bytes = std::string(kSessionMark) + "1\n";
    for (const SavedRun::Option& option : saved.options) bytes += "option " + option.name + " " + option.value + "\n";
    char hash[17];
    std::snprintf(hash, sizeof hash, "%016llx", static_cast<unsigned long long>(saved.hash));
    bytes += "reached " + std::to_string(saved.reached) + " " + hash + "\nshown " + std::to_string(saved.shown) + "\n";
    if (has_distances) {
        bytes += "distances " + std::to_string(matrix.size) + precision;
    } else {
        bytes += "points " + std::to_string(cloud.size()) + " " + std::to_string(cloud.dimension) + precision;
    }
    bytes += "view " + std::to_string(saved.view.size()) + "\ndata\n" + saved.view;
    const std::size_t numbers = has_distances && single ? matrix.narrow.size() : doubles.size();
    bytes.reserve(bytes.size() + numbers * (single ? sizeof(float) : sizeof(double)));
    if (has_distances && single) {
        for (const float number : matrix.narrow) append_f32(bytes, number, ByteOrder::LittleEndian);
    } else {
        append_numbers(bytes, doubles, single);
    }
    return bytes;
}

}  // namespace plateau
