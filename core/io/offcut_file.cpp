#include "core/io/offcut_file.h"

#include "core/io/document_file.h"
#include "core/io/formats.h"
#include "core/io/svg_format.h"
#include "core/io/svg_reader.h"

#include <algorithm>
#include <utility>

namespace fff::io {

namespace {

Result<SpareSheet> largestOf(const SvgDrawing &drawing, int count)
{
    std::vector<CurvePath> lines;
    for (const SvgDrawing::Line &line : drawing.lines)
        lines.push_back(line.path);
    return outlinesOf(joined(std::move(lines), kDrawnGap))
        .and_then([count](const std::vector<Outline> &outlines) -> Result<SpareSheet> {
            if (outlines.empty())
                return failure(ErrorCode::EmptyContour);
            return spareSheet(outlines.front(), count);
        });
}

} // namespace

Result<SpareSheet> readOffcut(const QString &path, int count)
{
    const std::string name = path.toStdString();
    Result<SpareSheet> spare = readFile(path).and_then([&](const std::string &bytes) {
        return svgFormat().readDrawing(bytes, name).and_then([count](const SvgDrawing &drawing) {
            return largestOf(drawing, count);
        });
    });
    if (!spare && spare.error().place.empty())
        spare.error().place = name;
    return spare;
}

} // namespace fff::io
