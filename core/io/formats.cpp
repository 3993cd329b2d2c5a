#include "core/io/formats.h"

#include "core/io/dxf_writer.h"
#include "core/io/fff_file.h"
#include "core/io/flatfab_format.h"
#include "core/io/gcode_writer.h"
#include "core/io/lightburn_writer.h"
#include "core/io/obj_writer.h"
#include "core/io/parts_csv.h"
#include "core/io/pdf_writer.h"
#include "core/io/png_writer.h"
#include "core/io/stl_writer.h"
#include "core/io/svg_format.h"
#include "core/io/threemf_writer.h"
#include "core/io/workshop_archive.h"

#include <QtCore/QFileInfo>

#include <algorithm>

namespace fff::io {

namespace {

std::vector<const Format *> &table()
{
    static std::vector<const Format *> formats = {
        &svgFormat(),      &dxfFormat(), &pdfFormat(),      &lightBurnFormat(), &gcodeFormat(),
        &partsCsvFormat(), &pngFormat(), &workshopFormat(), &objFormat(),       &stlFormat(),
        &threeMfFormat(),  &fffFormat(), &flatfabFormat(),
    };
    return formats;
}

bool isSuffix(const QString &suffix, const char *of)
{
    return suffix.compare(QLatin1String(of), Qt::CaseInsensitive) == 0;
}

template <class Predicate>
const Format *firstThat(Ability ability, Predicate fits)
{
    for (const Format *format : formats())
        if ((format->*ability)() && fits(*format))
            return format;
    return nullptr;
}

QString pattern(const char *suffix)
{
    return QStringLiteral("*.") + QLatin1String(suffix);
}

} // namespace

std::span<const Format *const> formats()
{
    return table();
}

std::vector<const Format *> formatsThat(Ability ability)
{
    std::vector<const Format *> found;
    std::copy_if(table().begin(), table().end(), std::back_inserter(found),
                 [ability](const Format *format) { return (format->*ability)(); });
    return found;
}

const Format &nativeFormat()
{
    return *firstThat(&Format::writesModels, [](const Format &) { return true; });
}

const Format *formatRead(const QString &path, Ability ability)
{
    const QString suffix = QFileInfo(path).suffix();
    return firstThat(ability, [&suffix](const Format &format) {
        return std::any_of(format.suffixes.begin(), format.suffixes.end(),
                           [&suffix](const char *one) { return isSuffix(suffix, one); });
    });
}

const Format *formatWritten(const QString &suffix, Ability ability)
{
    return firstThat(ability, [&suffix](const Format &format) {
        return isSuffix(suffix, format.suffixes.front());
    });
}

QString patternsRead(Ability ability)
{
    QStringList patterns;
    for (const Format *format : formatsThat(ability))
        for (const char *suffix : format->suffixes)
            patterns += pattern(suffix);
    return patterns.join(u' ');
}

QString patternOf(const Format &format)
{
    return pattern(format.suffixes.front());
}

AddedFormat::AddedFormat(const Format &format)
{
    table().push_back(&format);
}

AddedFormat::~AddedFormat()
{
    table().pop_back();
}

} // namespace fff::io
