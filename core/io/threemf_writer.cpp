#include "core/io/threemf_writer.h"

#include "core/io/archive.h"
#include "core/io/drawing_text.h"
#include "core/io/xml_text.h"

#include <QtCore/QCoreApplication>

#include <array>

namespace fff::io {

namespace {

constexpr std::string_view kTypes =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
    "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">"
    "<Default Extension=\"rels\" "
    "ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>"
    "<Default Extension=\"model\" "
    "ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/></Types>\n";
constexpr std::string_view kRelations =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
    "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
    "<Relationship Target=\"/3D/3dmodel.model\" Id=\"rel0\" "
    "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>\n";

void addObject(const PartSolid &solid, std::size_t id, DrawingText &out)
{
    out << "    <object id=\"" << std::to_string(id) << "\" type=\"model\" name=\""
        << escaped(solid.name) << "\"><mesh>\n      <vertices>\n";
    for (const Vec3 &p : solid.vertices)
        out << "<vertex x=\"" << p.x() << "\" y=\"" << p.y() << "\" z=\"" << p.z() << "\"/>\n";
    out << "      </vertices>\n      <triangles>\n";
    for (const auto &[a, b, c] : solid.triangles)
        out << "<triangle v1=\"" << std::to_string(a) << "\" v2=\"" << std::to_string(b)
            << "\" v3=\"" << std::to_string(c) << "\"/>\n";
    out << "      </triangles>\n    </mesh></object>\n";
}

std::string modelXml(const std::vector<PartSolid> &solids)
{
    std::size_t length = 1000;
    for (const PartSolid &solid : solids)
        length += 400 + 60 * solid.vertices.size() + 50 * solid.triangles.size();
    DrawingText out(length);
    out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
           "<model unit=\"millimeter\" xml:lang=\"en-US\" "
           "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">\n"
           "  <metadata name=\"Application\">FlatFitFab " FFF_VERSION "</metadata>\n"
           "  <resources>\n";
    for (std::size_t i = 0; i < solids.size(); ++i)
        addObject(solids[i], i + 1, out);
    out << "  </resources>\n  <build>\n";
    for (std::size_t i = 0; i < solids.size(); ++i)
        out << "    <item objectid=\"" << std::to_string(i + 1) << "\"/>\n";
    out << "  </build>\n</model>\n";
    return out.take();
}

} // namespace

Result<std::string> writeThreeMf(const Model &model, const Bodies &bodies, Lying lying)
{
    const Result<std::vector<PartSolid>> solids = partSolids(model, bodies, lying);
    if (!solids)
        return tl::unexpected(solids.error());
    const std::string xml = modelXml(*solids);
    const std::array<PackedEntry, 3> entries = {
        {{"[Content_Types].xml", kTypes}, {"_rels/.rels", kRelations}, {"3D/3dmodel.model", xml}}};
    return packed(entries);
}

const Format &threeMfFormat()
{
    static const Format format = {
        .key = "3mf",
        .suffixes = {"3mf"},
        .title = QT_TRANSLATE_NOOP("Format", "3MF, solids in place"),
        .help = QT_TRANSLATE_NOOP("CommandLine", "the parts to print"),
        .options = {lyingOption(QT_TRANSLATE_NOOP("Format", "3MF, solids lying flat"))},
        .writeSolids = [](const Model &model, const Bodies &bodies, const FormatValues &values) {
            return writeThreeMf(model, bodies, lyingOf(values));
        }};
    return format;
}

} // namespace fff::io
