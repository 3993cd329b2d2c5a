#include "tests/bench/report.h"

#include "core/io/json_writer.h"
#include "tests/bench/text_table.h"

#include <algorithm>
#include <array>

namespace fff::bench {

namespace {

using Row = TableRow;

struct Column
{
    const char *name;
    double Timings::*field;
};

constexpr std::array<Column, 15> kColumns{{{"load", &Timings::load},
                                           {"evaluate", &Timings::evaluate},
                                           {"slits", &Timings::slits},
                                           {"parts", &Timings::parts},
                                           {"SVG", &Timings::svg},
                                           {"drawing", &Timings::drawing},
                                           {"drag", &Timings::drag},
                                           {"edit", &Timings::edit},
                                           {"undo", &Timings::undo},
                                           {"anew", &Timings::anew},
                                           {"point", &Timings::point},
                                           {"gizmo", &Timings::gizmo},
                                           {"check", &Timings::check},
                                           {"plan", &Timings::plan},
                                           {"again", &Timings::again}}};

/// Ours over the peer's, both in kernels.
struct Ratio
{
    const char *name;
    double (*ours)(const Timings &);
    double (*peers)(const PeerRow &);
};

// The old program's SVG computes all slits again and draws outlines and slits as they are. Of ours
// that is slits and drawing; slits..SVG is all that an export does: slits cut out of the outlines,
// marks, kerf, layout.
constexpr std::array<Ratio, 6> kRatios{
    {{"load", [](const Timings &t) { return t.load; }, [](const PeerRow &p) { return p.load; }},
     {"slits", [](const Timings &t) { return t.slits; }, [](const PeerRow &p) { return p.slits; }},
     {"load+slits", [](const Timings &t) { return t.load + t.slits; },
      [](const PeerRow &p) { return p.load + p.slits; }},
     {"slits+drawing", [](const Timings &t) { return t.slits + t.drawing; },
      [](const PeerRow &p) { return p.svg; }},
     {"slits..SVG", [](const Timings &t) { return t.slits + t.parts + t.svg; },
      [](const PeerRow &p) { return p.svg; }},
     {"drag", [](const Timings &t) { return t.drag; }, [](const PeerRow &p) { return p.drag; }}}};

double ratio(const Ratio &r, const Measurement &row, const Peer &peer, const PeerRow &peerRow)
{
    return (r.ours(row.milliseconds) / row.kernel) / (r.peers(peerRow) / peer.kernel);
}

std::string timeTable(const std::vector<Measurement> &rows, bool inKernels)
{
    std::vector<Row> table{{"model", "sections", "joints", "edited has"}};
    for (const Column &column : kColumns)
        table.front().emplace_back(column.name);
    for (const Measurement &row : rows) {
        if (inKernels && !(row.kernel > 0.0))
            continue;
        Row cells{row.name, std::to_string(row.sections), std::to_string(row.joints),
                  std::to_string(row.neighbours)};
        for (const Column &column : kColumns) {
            const double ms = row.milliseconds.*column.field;
            cells.push_back(inKernels ? fixed(ms / row.kernel, 4) : fixed(ms, 3));
        }
        if (!inKernels && row.kernel > 0.0)
            cells.push_back(fixed(row.kernel, 1));
        table.push_back(std::move(cells));
    }
    if (!inKernels)
        table.front().emplace_back("kernel");
    return aligned(inKernels ? "Kernels" : "Milliseconds of CPU time of one thread", table);
}

std::string peerTable(const std::vector<Measurement> &rows, const Peer &peer)
{
    std::vector<Row> table{{"model"}};
    for (const Ratio &r : kRatios)
        table.front().emplace_back(r.name);
    for (const Measurement &row : rows) {
        const PeerRow *peerRow = peer.find(row.name);
        if (!peerRow || !(row.kernel > 0.0))
            continue;
        Row cells{row.name};
        for (const Ratio &r : kRatios)
            cells.push_back(fixed(ratio(r, row, peer, *peerRow), 3));
        table.push_back(std::move(cells));
    }
    return aligned("Ours over the old program's, in kernels (below 1: faster)", table);
}

std::string pointTable(const std::vector<Measurement> &rows)
{
    std::vector<Row> table{{"model", "section", "cut anew", "shape", "slits", "parts", "checks",
                            "arrays", "sum", "kernels"}};
    for (const Measurement &row : rows) {
        const PointEvent &e = row.point;
        table.push_back({row.name, std::to_string(e.section), std::to_string(e.touched),
                         fixed(e.shape, 3), fixed(e.slits, 3), fixed(e.parts, 3),
                         fixed(e.checks, 3), fixed(e.arrays, 3), fixed(e.sum(), 3),
                         row.kernel > 0.0 ? fixed(e.sum() / row.kernel, 4) : std::string("-")});
    }
    return aligned("The worst move of a control point, milliseconds", table);
}

/// Of models that differ in size alone, each beside the one before it.
std::string growthTable(const std::vector<Measurement> &rows)
{
    std::vector<Row> table{{"model", "sections", "joints", "first", "after an edit", "joints ×",
                            "first ×", "after an edit ×"}};
    const auto first = [](const Measurement &row) {
        return row.milliseconds.check + row.milliseconds.plan;
    };
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const Measurement &row = rows[i];
        const std::string family = familyOf(row.name);
        if (family.empty() || !(row.kernel > 0.0))
            continue;
        Row cells{row.name, std::to_string(row.sections), std::to_string(row.joints),
                  fixed(first(row) / row.kernel, 3), fixed(row.milliseconds.again / row.kernel, 3)};
        if (i > 0 && familyOf(rows[i - 1].name) == family && rows[i - 1].kernel > 0.0) {
            const Measurement &before = rows[i - 1];
            const double kernels = row.kernel / before.kernel;
            cells.push_back(fixed(static_cast<double>(row.joints) / before.joints, 1));
            cells.push_back(fixed(first(row) / first(before) / kernels, 1));
            cells.push_back(fixed(row.milliseconds.again / before.milliseconds.again / kernels, 1));
        }
        table.push_back(std::move(cells));
    }
    return aligned("Growth of the verdicts with the plan, kernels (× the model before)", table);
}

std::string memoryTable(const std::vector<Measurement> &rows)
{
    std::vector<Row> table{{"model", "sections", "counted", "expected", "with operations"}};
    for (const Measurement &row : rows)
        table.push_back({row.name, std::to_string(row.sections), std::to_string(row.step.counted),
                         std::to_string(row.step.expected), std::to_string(row.step.held)});
    return aligned("Bytes of one undo step (16 a section + the changed objects)", table);
}

} // namespace

std::string tables(const std::vector<Measurement> &rows, const std::optional<Peer> &peer)
{
    const bool hasKernels =
        std::any_of(rows.begin(), rows.end(), [](const auto &row) { return row.kernel > 0.0; });
    std::string out = timeTable(rows, false);
    if (hasKernels)
        out += timeTable(rows, true);
    if (hasKernels && peer)
        out += peerTable(rows, *peer);
    if (hasKernels)
        out += growthTable(rows);
    return out + pointTable(rows) + memoryTable(rows);
}

std::string json(const std::vector<Measurement> &rows, const std::optional<Peer> &peer)
{
    io::JsonWriter json;
    json.beginArray();
    for (const Measurement &row : rows) {
        json.beginObject();
        json.member("model", row.name);
        json.member("sections", row.sections);
        json.member("joints", row.joints);
        json.member("editedHas", row.neighbours);
        json.key("milliseconds");
        json.beginObject(io::JsonWriter::Layout::Line);
        for (const Column &column : kColumns)
            json.member(column.name, row.milliseconds.*column.field);
        json.endObject();
        json.member("stepBytes", row.step.counted);
        json.member("stepBytesExpected", row.step.expected);
        if (row.kernel > 0.0) {
            json.member("kernel", row.kernel);
            json.key("kernels");
            json.beginObject(io::JsonWriter::Layout::Line);
            for (const Column &column : kColumns)
                json.member(column.name, row.milliseconds.*column.field / row.kernel);
            json.endObject();
        }
        const PeerRow *peerRow = peer ? peer->find(row.name) : nullptr;
        if (peerRow && row.kernel > 0.0) {
            json.key("overPeer");
            json.beginObject(io::JsonWriter::Layout::Line);
            for (const Ratio &r : kRatios)
                json.member(r.name, ratio(r, row, *peer, *peerRow));
            json.endObject();
        }
        json.endObject();
    }
    json.endArray();
    return json.take();
}

} // namespace fff::bench
