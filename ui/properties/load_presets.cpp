#include "ui/properties/load_presets.h"

#include "core/model/load_names.h"

#include <QCoreApplication>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>

namespace fff::ui {

namespace {

// What the file calls them, to be translated.
[[maybe_unused]] constexpr const char *kNames[] = {
    QT_TRANSLATE_NOOP("LoadPreset", "Glass of water"), QT_TRANSLATE_NOOP("LoadPreset", "Fork"),
    QT_TRANSLATE_NOOP("LoadPreset", "Knife"),          QT_TRANSLATE_NOOP("LoadPreset", "Spoon"),
    QT_TRANSLATE_NOOP("LoadPreset", "Book"),           QT_TRANSLATE_NOOP("LoadPreset", "Plant pot"),
};

LoadPreset presetOf(const QJsonObject &row)
{
    LoadPreset preset;
    preset.key = row[QLatin1String("key")].toString().toStdString();
    preset.name = QCoreApplication::translate(
        "LoadPreset", row[QLatin1String("name")].toString().toUtf8().constData());
    preset.mass = row[QLatin1String("mass")].toDouble(preset.mass);
    preset.holds = row[QLatin1String("holds")].toDouble();
    preset.filled = row[QLatin1String("filled")].toDouble();
    preset.height = row[QLatin1String("height")].toDouble();
    preset.width = row[QLatin1String("width")].toDouble(preset.width);
    preset.spread =
        spreadNamed(row[QLatin1String("spread")].toString().toStdString()).value_or(Spread::Point);
    return preset;
}

} // namespace

const std::vector<LoadPreset> &loadPresets()
{
    static const std::vector<LoadPreset> presets = [] {
        std::vector<LoadPreset> all;
        QFile file(QStringLiteral(":/loads/presets.json"));
        if (file.open(QIODevice::ReadOnly))
            for (const QJsonValue &row : QJsonDocument::fromJson(file.readAll()).array())
                all.push_back(presetOf(row.toObject()));
        return all;
    }();
    return presets;
}

const LoadPreset *loadPreset(const std::string &key)
{
    const std::vector<LoadPreset> &all = loadPresets();
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const LoadPreset &preset) { return preset.key == key; });
    return found == all.end() ? nullptr : &*found;
}

Load taken(const LoadPreset &preset, Load load)
{
    const LoadPreset *before = loadPreset(load.preset);
    if (load.name.empty() || (before && load.name == before->name.toStdString()))
        load.name = preset.name.toStdString();
    load.preset = preset.key;
    load.mass = preset.mass + preset.filled;
    load.filled = preset.filled;
    load.height = preset.height;
    load.spread = preset.spread;
    load.width = preset.width;
    return load;
}

} // namespace fff::ui
