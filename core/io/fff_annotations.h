// What stands on the sections of a `.fff` file and beside them: figures, marks, dimensions and
// numbers with names. Internal to core/io; what is in them says fff_format.h.
#pragma once

#include "core/io/json_cursor.h"
#include "core/io/json_writer.h"
#include "core/model/document.h"

#include <functional>

namespace fff::io {

/// Members of a section; nothing where it has none.
void writeFigures(JsonWriter &json, const Section &section);
void writeMarks(JsonWriter &json, const Section &section);
/// Members of a document; nothing where it has none.
void writeDimensions(JsonWriter &json, const Document &document);
void writeNumbers(JsonWriter &json, const Document &document);

/// The member "frame".
void writeFrame(JsonWriter &json, const Frame &frame);

/// What a later version knows, or a hand has spoilt, is no figure: the boundary is there all the
/// same.
std::vector<Figure> readFigures(const JsonCursor &cursor, const ShapePointer &shape);
std::vector<MarkPointer> readMarks(const JsonCursor &cursor);

/// How the reader of the document reads what refers to something else in it.
struct ReferenceReaders
{
    std::function<SectionRef(const JsonCursor &)> readRef;
    std::function<std::int64_t(const JsonCursor &)> readId;
    std::function<Frame(const JsonCursor &, const std::string &ofWhat)> readFrame;
};
std::vector<Dimension> readDimensions(const JsonCursor &cursor, const ReferenceReaders &readers);
std::vector<NamedNumber> readNumbers(const JsonCursor &cursor);

} // namespace fff::io
