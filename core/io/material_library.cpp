#include "core/io/material_library.h"

#include "core/base/tolerances.h"
#include "core/io/json_cursor.h"
#include "core/io/json_syntax.h"
#include "core/model/edits.h"
#include "core/model/machine_kerfs.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QFile>
#include <QtCore/QJsonDocument>

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

namespace fff::io {

namespace {

constexpr std::size_t kMostMaterials = 1000, kMostThicknesses = 100;

template <class Read>
void ifSaid(const JsonCursor &cursor, const char *key, const Read &read)
{
    if (const JsonCursor member = cursor.member(key); member.exists())
        read(member);
}

/// All but what hangs on the thickness.
Stock readPlain(const JsonCursor &cursor)
{
    Stock stock;
    stock.name = cursor.member("name").text();
    stock.density = cursor.member("density").positive();
    stock.sheet = cursor.member("sheet").point2();
    for (const auto &[key, strength] :
         {std::pair("tensile", &stock.tensileStrength),
          std::pair("flexural", &stock.flexuralStrength), std::pair("modulus", &stock.modulus)})
        ifSaid(cursor, key,
               [strength = strength](const JsonCursor &value) { *strength = value.positive(); });
    ifSaid(cursor, "ductile",
           [&](const JsonCursor &ductile) { stock.isDuctile = ductile.truth(); });
    ifSaid(cursor, "lastingShare",
           [&](const JsonCursor &share) { stock.lastingShare = share.positive(); });
    ifSaid(cursor, "clearance",
           [&](const JsonCursor &clearance) { stock.clearance = clearance.coordinate(); });
    ifSaid(cursor, "price", [&](const JsonCursor &price) { stock.price = price.positive(); });
    return stock;
}

Stock readThickness(const JsonCursor &cursor, Stock stock)
{
    const double sold = cursor.member("sold").positive();
    stock.thickness = sold;
    ifSaid(cursor, "real", [&](const JsonCursor &real) { stock.thickness = real.positive(); });
    if (stock.thickness != sold)
        stock.nominalThickness = sold;
    ifSaid(cursor, "kerfs", [&](const JsonCursor &kerfs) {
        for (const auto &[machine, kerf] : kerfs.members())
            setKerf(stock, machine, kerf.notNegative());
    });
    stock.kerf = cursor.member("kerf").notNegative();
    return stock;
}

Material readMaterial(const JsonCursor &cursor, const Problems &problems)
{
    Material material;
    const Stock plain = readPlain(cursor);
    const std::vector<JsonCursor> thicknesses = cursor.member("thicknesses").items();
    if (thicknesses.empty() || thicknesses.size() > kMostThicknesses)
        cursor.fail(ErrorCode::BadCount,
                    {std::to_string(thicknesses.size()), std::to_string(kMostThicknesses),
                     QT_TRANSLATE_NOOP("Error", "thicknesses")});
    for (const JsonCursor &item : thicknesses) {
        material.stocks.push_back(readThickness(item, plain));
        if (problems.failed())
            break;
        // As the editor would refuse it.
        if (const auto added = addStock({}, material.stocks.back()); !added)
            item.fail(ErrorCode::BadValue,
                      {added.error().place, QT_TRANSLATE_NOOP("Error", "what a sheet can have")});
    }
    return material;
}

std::vector<Material> &knownMaterials()
{
    static std::vector<Material> all = [] {
        QFile file(QStringLiteral(":/materials/materials.json"));
        std::vector<Material> read;
        if (file.open(QIODevice::ReadOnly))
            if (auto known = readMaterials(file.readAll().toStdString(), "materials.json"))
                read = *std::move(known);
        return read; // not empty: a test reads the file
    }();
    return all;
}

} // namespace

Result<std::vector<Material>> readMaterials(std::string_view bytes, const std::string &name)
{
    Problems problems{name};
    const QJsonDocument json = parseJson(bytes, problems);
    const JsonCursor root(json.object(), "$", problems);
    std::vector<Material> materials;
    for (const JsonCursor &item : root.member("materials").items()) {
        if (problems.failed())
            break;
        if (materials.size() == kMostMaterials) {
            item.fail(ErrorCode::BadCount,
                      {std::to_string(kMostMaterials + 1), std::to_string(kMostMaterials),
                       QT_TRANSLATE_NOOP("Error", "materials")});
            break;
        }
        Material material = readMaterial(item, problems);
        if (problems.failed())
            break;
        if (std::any_of(materials.begin(), materials.end(),
                        [&](const Material &known) { return known.name() == material.name(); }))
            item.fail(ErrorCode::DuplicateId, {io::quoted(material.name())});
        materials.push_back(std::move(material));
    }
    if (problems.failed())
        return tl::unexpected(*problems.error);
    return materials;
}

std::span<const Material> materialLibrary()
{
    return knownMaterials();
}

void addOwnMaterials(std::vector<Material> own)
{
    std::vector<Material> &all = knownMaterials();
    for (const Material &material : own)
        std::erase_if(all, [&](const Material &known) { return known.name() == material.name(); });
    all.insert(all.begin(), std::make_move_iterator(own.begin()),
               std::make_move_iterator(own.end()));
}

} // namespace fff::io
