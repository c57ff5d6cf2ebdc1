// course_bench: the table and the readers beside other libraries (see `run`).
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <stdexcept>

#include "course/bench/accepted.h"
#include "course/bench/fresh_process.h"
#include "course/bench/meshes.h"
#include "course/bench/peers.h"
#include "course/bench/report.h"
#include "course/bench/subscript.h"
#include "course/halfedge/build.h"
#include "course/mesh/obj.h"
#include "course/mesh/off.h"
#include "course/runner/temporary_folder.h"

namespace bench {

namespace {

struct Options {
    bool quick = false;
    int rounds = 12;
    std::vector<std::string> parts;
    std::vector<std::string> files;

    bool wants(const std::string& part) const {
        return parts.empty() ||
               std::find(parts.begin(), parts.end(), part) != parts.end();
    }
};

/// Takes each run of `what/who` into the results.
class Collector : public benchmark::BenchmarkReporter {
public:
    Collector(Results& times, Results& peaks) : times_(times), peaks_(peaks) {}

    bool ReportContext(const Context&) override { return true; }

    void ReportRuns(const std::vector<Run>& runs) override {
        for (const Run& run : runs) {
            if (run.run_type == Run::RT_Aggregate) continue;
            const std::string& name = run.run_name.function_name;
            const std::size_t slash = name.find('/');
            const std::string what = name.substr(0, slash);
            const std::string who = name.substr(slash + 1);
            if (run.error_occurred)
                throw std::runtime_error(name + ": " + run.error_message);
            const bool manual = run.counters.count("peak") > 0;
            const double time =
                manual ? run.real_accumulated_time : run.cpu_accumulated_time;
            times_.add(what, who, time / static_cast<double>(run.iterations));
            if (manual) peaks_.add(what, who, run.counters.at("peak"));
        }
    }

private:
    Results& times_;
    Results& peaks_;
};

/// What is measured together, in one mix, and printed as one table.
class Mix {
public:
    explicit Mix(int rounds) : rounds_(rounds) {}

    /// Measured in a process of its own, with the memory it takes.
    void add_fresh(const std::string& what, const std::string& who,
                   const std::function<void()>& work) {
        times_.expect(what);
        peaks_.expect(what);
        benchmark::RegisterBenchmark(
            (what + "/" + who).c_str(),
            [work](benchmark::State& state) {
                for (auto _ : state) {
                    const Cost cost = cost_of(work);
                    state.SetIterationTime(cost.seconds);
                    state.counters["peak"] = static_cast<double>(cost.peak);
                }
            })
            ->UseManualTime()
            ->Iterations(1);
    }

    /// Measured in many short runs: on a shared machine the best of them is
    /// less of an accident than the best of a few long ones.
    void add_repeated(const std::string& what, const std::string& who,
                      const std::function<double()>& work) {
        times_.expect(what);
        benchmark::RegisterBenchmark((what + "/" + who).c_str(),
                                     [work](benchmark::State& state) {
                                         for (auto _ : state)
                                             benchmark::DoNotOptimize(work());
                                     })
            ->MinTime(0.005)
            ->Repetitions(4 * rounds_);
    }

    void run(const std::string& title, const std::vector<std::string>& who,
             double per, const char* unit) {
        Collector collector(times_, peaks_);
        benchmark::RunSpecifiedBenchmarks(&collector);
        benchmark::ClearRegisteredBenchmarks();
        fmt::print("{}\n{}", title, times_.table(who, 1e9 / per, unit));
        const std::string memory = peaks_.table(who, 1 / per, "bytes");
        if (memory.find('\n') + 1 < memory.size())
            fmt::print("  peak memory\n{}", memory);
        fmt::print("\n");
        std::fflush(stdout);
    }

private:
    int rounds_;
    Results times_;
    Results peaks_;
};

std::vector<std::string> names_of(const std::vector<Peer>& all) {
    std::vector<std::string> names;
    for (const Peer& peer : all) names.emplace_back(peer.name);
    return names;
}

// ---- building and walking

constexpr std::array<std::pair<Walk, const char*>, 6> walks = {
    {{Walk::stars, "all stars"},
     {Walk::faces, "all faces"},
     {Walk::adjacent_faces, "adjacent faces"},
     {Walk::border_loops, "border loops"},
     {Walk::vertex_normals, "vertex normals"},
     {Walk::back_to_faces, "back to faces"}}};

/// The sums of the peers tell whether they walked on the same mesh.
void require_same_sum(const Built& own, const Built& other, const Peer& peer) {
    for (const auto& [walk, name] : walks) {
        const double a = own.sum(walk);
        const double b = other.sum(walk);
        if (!(std::abs(a - b) <= 1e-6 * std::abs(a) + 1e-6))
            throw std::runtime_error(
                fmt::format("{}: the course's sum is {}, that of {} is {}",
                            name, a, peer.name, b));
    }
}

void measure_mesh(const Case& one, int rounds) {
    const std::vector<Peer> all = peers();
    std::vector<std::unique_ptr<Built>> built;
    Mix mix(rounds);
    for (const Peer& peer : all) {
        if (peer.table)
            mix.add_fresh("half-edges alone", peer.name,
                          [&] { peer.table(one.mesh); });
        if (!peer.build) continue;
        mix.add_fresh("build", peer.name,
                      [&] { keep(peer.build(one.mesh).get()); });
        built.push_back(peer.build(one.mesh));
        const Built& mesh = *built.back();
        if (std::string_view(peer.name) != "bytes")
            require_same_sum(*built.front(), mesh, peer);
        for (const auto& [walk, name] : walks)
            mix.add_repeated(name, peer.name,
                             [&mesh, w = walk] { return mesh.sum(w); });
    }
    mix.run(fmt::format("{}: {} vertices, {} faces; per face", one.name,
                        one.mesh.vertex_count(), one.mesh.faces.size()),
            names_of(all), one.mesh.faces.size(), "ns");
}

// ---- files

void measure_file(const std::filesystem::path& file, int rounds) {
    const std::vector<Peer> all = peers();
    Mix mix(rounds);
    const bool obj = file.extension() == ".obj";
    const auto add = [&](const char* what, const Peer& peer, Peer::Read read) {
        if (read) mix.add_fresh(what, peer.name, [=] { read(file); });
    };
    for (const Peer& peer : all) {
        add("read and build", peer, obj ? peer.read_obj : peer.read_off);
        add("read faces", peer, obj ? peer.obj_faces : peer.off_faces);
    }
    const auto bytes = static_cast<double>(std::filesystem::file_size(file));
    mix.run(fmt::format("{}, {:.1f} MB; per byte of the file",
                        file.filename().string(), bytes / 1e6),
            names_of(all), bytes, "ns");
}

void measure_as_files(const Case& one, int rounds) {
    const course::TemporaryFolder folder;
    course::write_obj(folder / (one.name + ".obj"), one.mesh);
    course::write_off(folder / (one.name + ".off"), one.mesh);
    measure_file(folder / (one.name + ".obj"), rounds);
    measure_file(folder / (one.name + ".off"), rounds);
}

// ---- the subscript

/// The traced one only where its events fit into memory.
void measure_subscript(const Case& one, int rounds, bool traced) {
    const HalfEdgeTable he = course::build(one.mesh);
    Rows rows;
    std::vector<int> leaving(one.mesh.positions.size(), -1);
    for (const HalfEdge& row : he.rows()) {
        leaving[static_cast<std::size_t>(row.vi)] =
            static_cast<int>(rows.size());
        rows.push_back({row.vi, row.fi, row.next, row.opp});
    }
    Mix mix(rounds);
    for (const Subscript& by : subscripts()) {
        if (by.traced && !traced) continue;
        const std::string what = fmt::format("{}, {}", by.compiled,
                                             by.traced ? "traced" : "checked");
        mix.add_repeated(what, "he[i]", by.table(rows, leaving));
        mix.add_repeated(what, "raw pointer", by.raw(rows, leaving));
    }
    mix.run(fmt::format("he[i], all stars of {} half-edges; per half-edge",
                        he.size()),
            {"he[i]", "raw pointer"}, he.size(), "ns");
}

// ---- the command

void measure_made(const Options& options) {
    for (const std::string& name : made_meshes()) {
        const Case one = made_mesh(name, options.quick);
        if (options.wants(name)) measure_mesh(one, options.rounds);
        if (options.wants("files") && name == "triangles_1M")
            measure_as_files(one, options.rounds);
        if (options.wants("subscript") && name == "triangles_1M") {
            measure_subscript(one, options.rounds, false);
            measure_subscript(made_mesh(name, true), options.rounds, true);
        }
    }
}

void measure(const Options& options) {
    if (options.files.empty()) measure_made(options);
    if (options.files.empty() && options.wants("accepted"))
        count_accepted(options.quick ? 100 : 2000);
    for (const std::string& file : options.files) {
        measure_mesh(mesh_of_file(file), options.rounds);
        measure_file(file, options.rounds);
    }
}

void start_benchmark(const Options& options) {
    std::vector<std::string> words = {
        "course_bench", "--benchmark_enable_random_interleaving=true",
        fmt::format("--benchmark_repetitions={}", options.rounds)};
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    int argc = static_cast<int>(argv.size());
    benchmark::Initialize(&argc, argv.data());
}

}  // namespace

std::vector<Subscript>& subscripts() {
    static std::vector<Subscript> all;
    return all;
}

}  // namespace bench

int main(int argc, char** argv) {
    bench::Options options;
    CLI::App app("Measures the half-edge table beside other libraries.");
    app.add_flag("--quick", options.quick, "meshes a hundred times smaller");
    app.add_option("--rounds", options.rounds, "the best of so many runs")
        ->check(CLI::Range(1, 100))
        ->capture_default_str();
    std::vector<std::string> parts = bench::made_meshes();
    parts.insert(parts.end(), {"files", "subscript", "accepted"});
    app.add_option("--part", options.parts, "only these parts")
        ->check(CLI::IsMember(parts));
    app.add_option("files", options.files, "OBJ and OFF files instead")
        ->check(CLI::ExistingFile);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;
    }
    try {
        bench::start_benchmark(options);
        bench::measure(options);
    } catch (const std::exception& error) {
        fmt::print(stderr, "course_bench: {}\n", error.what());
        return 3;
    }
}
