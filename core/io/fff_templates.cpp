#include "core/io/fff_templates.h"

#include "core/io/blobs.h"
#include "core/io/fff_operations.h"

#include <QtCore/QCoreApplication>

namespace fff::io {

namespace {

const char *templateKindName(TemplateKind kind)
{
    switch (kind) {
    case TemplateKind::Mesh:
        break;
    case TemplateKind::Picture:
        return "picture";
    case TemplateKind::Curves:
        return "curves";
    }
    return "mesh";
}

void writeMagnets(JsonWriter &json, const Template &one)
{
    if (one.magnets.empty())
        return;
    json.key("magnets");
    json.beginArray();
    for (const Magnet &magnet : one.magnets) {
        json.beginObject(JsonWriter::Layout::Line);
        json.key("section");
        writeRef(json, magnet.section);
        json.member("radius", magnet.radius);
        json.endObject();
    }
    json.endArray();
}

void writeTemplate(JsonWriter &json, const Template &one)
{
    json.beginObject();
    json.member("id", one.id.value);
    json.member("kind", templateKindName(one.kind));
    json.member("name", one.name);
    if (!one.blob.empty())
        json.member("blob", one.blob);
    if (!one.file.empty())
        json.member("file", one.file);
    if (one.on != SectionRef()) {
        json.key("on");
        writeRef(json, one.on);
    }
    writeFrame(json, one.frame);
    json.member("scale", one.scale);
    if (one.isFlipped)
        json.member("flipped", true);
    json.member("opacity", one.opacity);
    if (one.isHidden)
        json.member("hidden", true);
    if (one.isLocked)
        json.member("locked", true);
    writeMagnets(json, one);
    json.endObject();
}

TemplateKind readTemplateKind(const JsonCursor &cursor)
{
    const std::string name = cursor.text();
    for (const TemplateKind kind :
         {TemplateKind::Mesh, TemplateKind::Picture, TemplateKind::Curves})
        if (name == templateKindName(kind))
            return kind;
    cursor.failExpected(QT_TRANSLATE_NOOP("Error", "mesh, picture or curves"));
    return TemplateKind::Mesh;
}

/// `kept` where it is missing.
bool readTruth(const JsonCursor &cursor, bool kept)
{
    return cursor.exists() ? cursor.truth() : kept;
}

void readMagnets(const JsonCursor &cursor, const ReferenceReaders &readers, Template &one)
{
    if (!cursor.exists())
        return;
    if (one.isFlat())
        cursor.failExpected(QT_TRANSLATE_NOOP("Error", "nothing: only meshes are pulled"));
    for (const JsonCursor &item : cursor.items()) {
        const JsonCursor radius = item.member("radius");
        one.magnets.push_back({readers.readRef(item.member("section")), radius.number()});
        if (const double r = one.magnets.back().radius; !(r >= kLeastMagnet && r <= kMostMagnet))
            radius.failExpected(QT_TRANSLATE_NOOP("Error", "a radius from 0.1 to 1000 mm"));
    }
    settleMagnets(one);
}

void readSource(const JsonCursor &cursor, Template &one)
{
    const JsonCursor blob = cursor.member("blob"), file = cursor.member("file");
    if (blob.exists())
        one.blob = blob.text();
    if (file.exists())
        one.file = file.text();
    if (blob.exists() && !isSha256(one.blob))
        blob.failExpected(QT_TRANSLATE_NOOP("Error", "a SHA-256 in 64 hexadecimal digits"));
    if (file.exists() && one.file.empty())
        file.failExpected(QT_TRANSLATE_NOOP("Error", "the path of a file"));
    if (!blob.exists() && !file.exists())
        cursor.failExpected(QT_TRANSLATE_NOOP("Error", "a blob's SHA-256, or a file"));
}

Template readTemplate(const JsonCursor &cursor, const ReferenceReaders &readers)
{
    Template one;
    one.id = TemplateId{readers.readId(cursor.member("id"))};
    one.kind = readTemplateKind(cursor.member("kind"));
    one.name = cursor.member("name").text();
    readSource(cursor, one);
    const JsonCursor on = cursor.member("on");
    if (on.exists())
        one.on = readers.readRef(on);
    if (on.exists() && !one.isFlat())
        on.failExpected(QT_TRANSLATE_NOOP("Error", "nothing: a mesh lies on no section"));
    one.frame = readers.readFrame(cursor.member("frame"), one.name);
    const JsonCursor scale = cursor.member("scale");
    one.scale = scale.number();
    if (!(one.scale >= kLeastTemplateScale && one.scale <= kMostTemplateScale))
        scale.failExpected(QT_TRANSLATE_NOOP("Error", "a scale from 1e-9 to 1e9"));
    one.isFlipped = readTruth(cursor.member("flipped"), false);
    const JsonCursor opacity = cursor.member("opacity");
    one.opacity = opacity.number();
    if (!(one.opacity >= 0.0 && one.opacity <= 1.0))
        opacity.failExpected(QT_TRANSLATE_NOOP("Error", "an opacity from 0 to 1"));
    one.isHidden = readTruth(cursor.member("hidden"), false);
    one.isLocked = readTruth(cursor.member("locked"), false);
    readMagnets(cursor.member("magnets"), readers, one);
    return one;
}

} // namespace

void writeTemplates(JsonWriter &json, const Document &document)
{
    if (document.templates.empty())
        return;
    json.key("templates");
    json.beginArray();
    for (const TemplatePointer &one : document.templates)
        writeTemplate(json, *one);
    json.endArray();
}

std::vector<TemplatePointer> readTemplates(const JsonCursor &cursor,
                                           const ReferenceReaders &readers)
{
    std::vector<TemplatePointer> templates;
    if (!cursor.exists())
        return templates;
    for (const JsonCursor &item : cursor.items())
        templates.push_back(std::make_shared<const Template>(readTemplate(item, readers)));
    return templates;
}

} // namespace fff::io
