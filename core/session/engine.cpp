#include "session/engine.h"

#include <algorithm>
#include <array>

namespace plateau {

namespace {

std::uint32_t largest_entry(const std::vector<std::vector<std::uint32_t>>& nu) {
    std::uint32_t largest = 1;
    for (const auto& sequence : nu) {
        for (const std::uint32_t entry : sequence) largest = std::max(largest, entry);
    }
    return largest;
}

LandmarkLists lists_of(const PointCloud& cloud, const EngineOptions& options) {
    const std::uint32_t kappa = largest_entry(options.nu);
    if (options.metric.metric == Metric::Euclidean) return {cloud, kappa};
    return {make_distance_rows(cloud, options.metric), cloud.size(), kappa};
}

}  // namespace

Engine::Engine(const PointCloud& cloud, const EngineOptions& options)
    : cloud_(&cloud), options_(options), lists_(lists_of(cloud, options)) {
    timeline_.dimension = options.dimension;
    timeline_.family = options.family;
    timeline_.track_count = static_cast<int>(options.nu.size());
    timeline_.simplices.resize(options.dimension);
    for (std::uint32_t k = 1; k <= options.dimension; ++k) timeline_.simplices[k - 1].dimension = static_cast<int>(k);

    const bool follows_surface = options.family == Family::Surface || options.family == Family::Auto;
    if (options.family == Family::Dilated) {
        dilated_.emplace(cloud.dimension, options.dilated);
    } else {
        complex_.emplace(options.nu, static_cast<int>(options.dimension), cloud.size());
    }
    if (is_within_delaunay(options.family)) {
        delaunay_.emplace(cloud.dimension);
    } else {
        timeline_.other_field = options.other_field;
        general_.emplace(static_cast<int>(timeline_.dimension), std::array{options.field, options.other_field});
    }
    if (follows_surface) {
        surface_.emplace(options.rho);
        surface_betti_.emplace();
    }
    if (options.family == Family::Delaunay) embedded_.emplace(0);
    if (options.family == Family::Auto) embedded_.emplace(1);
}

std::optional<Error> Engine::begin_step(std::uint32_t input_index) {
    const Step step = timeline_.step_count + 1;
    const std::uint32_t nearest = lists_.list(lists_.witness(input_index))[0];

    if (delaunay_) {
        auto inserted = delaunay_->insert(step, cloud_->point(input_index), nearest);
        if (!inserted) return inserted.error();
        change_ = inserted.value();
        expect(*change_);
    }
    const auto entries = lists_.insert(input_index, step);
    timeline_.landmarks.push_back(input_index);
    timeline_.epsilons.push_back(lists_.distance(lists_.farthest_comparable()));
    timeline_.delaunay_dimension.push_back(static_cast<std::uint8_t>(change_ == nullptr ? 0 : change_->dimension));

    if (dilated_) return std::nullopt;
    if (change_ == nullptr) {
        complex_->insert(step, lists_, entries, timeline_.simplices);
    } else {
        complex_->insert(step, lists_, entries, *delaunay_, *change_, timeline_.simplices);
    }
    record_deaths(complex_->deaths());
    return std::nullopt;
}

bool Engine::finish_step(const Deadline& deadline) {
    const Step step = timeline_.step_count + 1;
    Slice slice(deadline);
    if (dilated_ && !is_followed_) {
        if (!follow_dilated(step, slice)) return false;
        is_followed_ = true;
    }
    if (surface_) {
        const LandmarkPoints points{cloud_, &timeline_.landmarks};
        if (!surface_->update(step, *delaunay_, *change_, *complex_, complex_->deaths(), points, timeline_, slice)) {
            return false;
        }
        timeline_.first_row_of_step.push_back(static_cast<std::uint32_t>(timeline_.surface.size()));
        timeline_.first_ended_row_of_step.push_back(timeline_.ended_rows.size());
        surface_betti_->update(*surface_, static_cast<std::uint32_t>(timeline_.surface.size()));
    }
    if (embedded_) {
        embedded_->update(step, timeline_.simplices, complex_->deaths(), *delaunay_, *change_, complex_->faces());
    }
    if (general_ && !count_cycles(step, slice)) return false;
    if (dilated_) record_dilated(step);
    is_followed_ = false;
    record_numbers();
    timeline_.step_count = step;
    return true;
}

// Asks the memory for what the insertion will touch, while the lists are at work.
void Engine::expect(const DelaunayChange& change) const {
    const auto expect_cell = [&](CellId cell) {
        complex_->expect(cell);
        if (embedded_) embedded_->expect(cell);
        if (surface_) surface_->expect(cell);
    };
    for (const CellId id : change.died) expect_cell(id);
    const Step step = timeline_.step_count + 1;
    for (const CellId id : change.born) {
        const DelaunayCell& cell = delaunay_->cell(id);
        expect_cell(cell.neighbor[static_cast<std::size_t>(cell.index_of_vertex(step))]);
    }
}

bool Engine::follow_dilated(Step step, Slice& slice) {
    const WitnessId witness = lists_.witness(timeline_.landmarks.back());
    return dilated_->insert(step, witness, timeline_.epsilon(step), lists_, timeline_.simplices, slice);
}

void Engine::record_dilated(Step step) {
    timeline_.weights_squared.push_back(dilated_->landmarks().weight_squared(step));
    if (options_.dilated.pumps) timeline_.pumps.push_back(dilated_->pump());
    for (const Step landmark : dilated_->hidden()) timeline_.hidden.push_back({landmark, step});
    record_deaths(dilated_->deaths());
}

bool Engine::count_cycles(Step step, Slice& slice) {
    const auto& tables = timeline_.simplices;
    if (!dilated_) return general_->update(step, tables, complex_->books(), complex_->deaths(), {}, slice);
    return general_->update(step, tables, dilated_->books(), dilated_->deaths(), dilated_->hidden(), slice);
}

void Engine::record_deaths(std::span<const Death> deaths) {
    timeline_.deaths.insert(timeline_.deaths.end(), deaths.begin(), deaths.end());
    timeline_.first_death_of_step.push_back(timeline_.deaths.size());
}

void Engine::record_numbers() {
    const std::uint32_t d = timeline_.dimension;
    const bool shows_surface =
        options_.family == Family::Surface || (surface_betti_ && surface_betti_->numbers().front() > 0);
    if (general_) {
        const auto numbers = general_->numbers(0);
        timeline_.betti.insert(timeline_.betti.end(), numbers.begin(), numbers.end());
        const auto others = general_->numbers(1);
        timeline_.other_betti.insert(timeline_.other_betti.end(), others.begin(), others.end());
    } else {
        const auto numbers = shows_surface ? surface_betti_->numbers() : embedded_->numbers();
        timeline_.betti.insert(timeline_.betti.end(), numbers.begin(), numbers.begin() + d);
    }
    const Family complex = options_.family == Family::Auto ? Family::Delaunay : options_.family;
    timeline_.shown_family.push_back(shows_surface ? Family::Surface : complex);
}

std::uint64_t Engine::hash_at(Step step) {
    if (step < hashed_) {
        hashed_ = 0;
        hash_ = {};
    }
    while (hashed_ < step) extend_hash(++hashed_);
    return hash_.value();
}

// Step, landmark, bits of epsilon, births, deaths, surface rows, weight and hidden landmarks, shown family and Betti
// numbers.
void Engine::extend_hash(Step step) {
    hash_.add_u32(step);
    hash_.add_u32(timeline_.landmarks[step - 1]);
    hash_.add_f64(timeline_.epsilon(step));
    for (const SimplexTable& table : timeline_.simplices) {
        for (SimplexIndex s = table.first_of_step[step]; s < table.first_of_step[step + 1]; ++s) {
            for (const Step vertex : table.tuple(s)) hash_.add_u32(vertex);
            for (int track = 0; track < timeline_.track_count; ++track) {
                hash_.add_byte(table.death[static_cast<std::size_t>(track)][s] > step ? 1 : 0);
            }
        }
    }
    for (std::size_t i = timeline_.first_death_of_step[step]; i < timeline_.first_death_of_step[step + 1]; ++i) {
        const Death& death = timeline_.deaths[i];
        hash_.add_byte(death.track);
        for (const Step vertex : timeline_.table(death.dimension).tuple(death.simplex)) hash_.add_u32(vertex);
    }
    if (surface_) {
        const auto add_row = [&](std::uint32_t index) {
            const SurfaceRow& row = timeline_.surface[index];
            for (const Step vertex : timeline_.table(2).tuple(row.triangle)) hash_.add_u32(vertex);
            hash_.add_byte(row.side);
        };
        const auto& rows = timeline_.first_row_of_step;
        const auto& ended = timeline_.first_ended_row_of_step;
        for (std::uint32_t row = rows[step]; row < rows[step + 1]; ++row) add_row(row);
        for (std::size_t i = ended[step]; i < ended[step + 1]; ++i) add_row(timeline_.ended_rows[i]);
    }
    if (dilated_) {
        hash_.add_f64(timeline_.weights_squared[step - 1]);
        for (; hashed_hidden_ < timeline_.hidden.size() && timeline_.hidden[hashed_hidden_].from <= step;
             ++hashed_hidden_)
            hash_.add_u32(timeline_.hidden[hashed_hidden_].landmark);
    }
    hash_.add_byte(static_cast<std::uint8_t>(timeline_.shown_family[step - 1]));
    for (const std::uint32_t beta : timeline_.betti_at(step)) hash_.add_u32(beta);
}

std::uint64_t Engine::memory() const {
    constexpr std::uint64_t kBytesPerCell = 84 + sizeof(DelaunayCell);  // CGAL's and ours
    std::uint64_t bytes = lists_.memory();
    if (delaunay_) bytes += delaunay_->cell_capacity() * kBytesPerCell;
    bytes += dilated_ ? dilated_->memory() : complex_->memory();
    for (const SimplexTable& table : timeline_.simplices) {
        bytes += sizeof(Step) * (table.vertices.capacity() + table.death[0].capacity() + table.death[1].capacity());
    }
    bytes += timeline_.deaths.capacity() * sizeof(Death) + timeline_.surface.capacity() * sizeof(SurfaceRow);
    if (surface_) bytes += surface_->memory() + surface_betti_->memory();
    if (embedded_) bytes += embedded_->memory();
    if (general_) bytes += general_->memory();
    return bytes;
}

}  // namespace plateau
