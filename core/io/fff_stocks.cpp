#include "core/io/fff_stocks.h"

#include <QtCore/QCoreApplication>
#include <optional>
#include <string>
#include <utility>

namespace fff::io {

namespace {

using Layout = JsonWriter::Layout;

void writeRated(JsonWriter &json, const char *name, const std::optional<double> &value)
{
    json.key(name);
    if (value)
        json.value(*value);
    else
        json.null();
}

const char *slitEndName(SlitEnd end)
{
    switch (end) {
    case SlitEnd::Square:
        break;
    case SlitEnd::Round:
        return "round";
    case SlitEnd::Dogbone:
        return "dogbone";
    case SlitEnd::TBone:
        return "tBone";
    }
    return "square";
}

/// Nothing for what is as in a new stock: brittle, and as strong for months.
void writeEndurance(JsonWriter &json, const Stock &stock)
{
    if (stock.isDuctile)
        json.member("ductile", true);
    if (stock.lastingShare != 1.0)
        json.member("lastingShare", stock.lastingShare);
}

/// Nothing for what is as in a new stock: plain slits.
void writeSlitForm(JsonWriter &json, const Stock &stock)
{
    const Stock plain;
    if (stock.slitEnd != plain.slitEnd)
        json.member("slitEnd", slitEndName(stock.slitEnd));
    if (stock.toolDiameter != plain.toolDiameter)
        json.member("toolDiameter", stock.toolDiameter);
    if (stock.leadIn != plain.leadIn)
        json.member("leadIn", stock.leadIn);
    if (stock.bumps != plain.bumps)
        json.member("bumps", stock.bumps);
}

/// Nothing where it is sold by how thick it is, and nobody has measured it.
void writeMeasuring(JsonWriter &json, const Stock &stock)
{
    if (stock.nominalThickness)
        json.member("nominalThickness", *stock.nominalThickness);
    if (stock.isMeasured)
        json.member("measured", true);
}

void writeKerfs(JsonWriter &json, const Stock &stock)
{
    if (stock.kerfs.empty())
        return;
    json.key("kerfs");
    json.beginArray();
    for (const MachineKerf &one : stock.kerfs) {
        json.beginObject(Layout::Line);
        json.member("machine", one.machine);
        json.member("kerf", one.kerf);
        json.endObject();
    }
    json.endArray();
}

void writeSheets(JsonWriter &json, const Stock &stock, const ShapeWriter &writeShape)
{
    if (stock.sheetCount)
        json.member("sheetCount", *stock.sheetCount);
    if (stock.spares.empty())
        return;
    json.key("offcuts");
    json.beginArray();
    for (const SpareSheet &spare : stock.spares) {
        json.beginObject();
        if (spare.count != 1)
            json.member("count", spare.count);
        json.key("shape");
        writeShape(json, *spare.shape);
        json.endObject();
    }
    json.endArray();
}

std::optional<double> readRated(const JsonCursor &cursor)
{
    if (cursor.isNull())
        return std::nullopt;
    return cursor.positive();
}

/// What is missing is as in a new stock.
void readSlitForm(const JsonCursor &cursor, Stock &stock)
{
    if (const JsonCursor end = cursor.member("slitEnd"); end.exists()) {
        const std::string name = end.text();
        if (name == "square")
            stock.slitEnd = SlitEnd::Square;
        else if (name == "round")
            stock.slitEnd = SlitEnd::Round;
        else if (name == "dogbone")
            stock.slitEnd = SlitEnd::Dogbone;
        else if (name == "tBone")
            stock.slitEnd = SlitEnd::TBone;
        else
            end.failExpected(QT_TRANSLATE_NOOP("Error", "square, round, dogbone or tBone"));
    }
    if (const JsonCursor tool = cursor.member("toolDiameter"); tool.exists())
        stock.toolDiameter = tool.positive();
    if (const JsonCursor leadIn = cursor.member("leadIn"); leadIn.exists())
        stock.leadIn = leadIn.notNegative();
    if (const JsonCursor bumps = cursor.member("bumps"); bumps.exists())
        stock.bumps = bumps.notNegative();
}

void readKerfs(const JsonCursor &cursor, Stock &stock)
{
    if (!cursor.exists())
        return;
    for (const JsonCursor &item : cursor.items()) {
        MachineKerf one{item.member("machine").text(), item.member("kerf").notNegative()};
        if (!stock.kerfs.empty() && !(stock.kerfs.back().machine < one.machine))
            item.failExpected(QT_TRANSLATE_NOOP("Error", "each machine once, in their order"));
        stock.kerfs.push_back(std::move(one));
    }
}

void readOffcuts(const JsonCursor &cursor, const StockReaders &readers, Stock &stock)
{
    if (!cursor.exists())
        return;
    int count = 0;
    for (const JsonCursor &item : cursor.items()) {
        SpareSheet spare;
        if (const JsonCursor several = item.member("count"); several.exists())
            spare.count = static_cast<int>(several.integer(1, kMostSpares));
        spare.shape = readers.readShape(item.member("shape"));
        if (!spare.shape)
            return; // it has been said why
        count += spare.count;
        if (stock.spares.size() == kMostSpareKinds || count > kMostSpares)
            return item.fail(ErrorCode::BadCount,
                             {std::to_string(count), std::to_string(kMostSpares),
                              QT_TRANSLATE_NOOP("Error", "offcuts")});
        if (!isUsable(spare))
            return item.failExpected(
                QT_TRANSLATE_NOOP("Error", "an outline from 0, 0 on that does not cross itself"));
        stock.spares.push_back(std::move(spare));
    }
}

/// How thick it is sold and whether it was measured, what machines make of it, which sheets there
/// are.
void readWarehouse(const JsonCursor &cursor, const StockReaders &readers, Stock &stock)
{
    if (const JsonCursor nominal = cursor.member("nominalThickness"); nominal.exists())
        stock.nominalThickness = nominal.positive();
    if (const JsonCursor measured = cursor.member("measured"); measured.exists())
        stock.isMeasured = measured.truth();
    readKerfs(cursor.member("kerfs"), stock);
    if (const JsonCursor count = cursor.member("sheetCount"); count.exists())
        stock.sheetCount = static_cast<int>(count.integer(1, kMostSheets));
    readOffcuts(cursor.member("offcuts"), readers, stock);
}

} // namespace

void writeStock(JsonWriter &json, const Stock &stock, const ShapeWriter &writeShape)
{
    json.beginObject();
    json.member("id", stock.id.value);
    json.member("name", stock.name);
    json.member("thickness", stock.thickness);
    writeMeasuring(json, stock);
    json.member("density", stock.density);
    writeRated(json, "tensileStrength", stock.tensileStrength);
    writeRated(json, "flexuralStrength", stock.flexuralStrength);
    writeRated(json, "modulus", stock.modulus);
    writeEndurance(json, stock);
    json.member("kerf", stock.kerf);
    writeKerfs(json, stock);
    json.member("clearance", stock.clearance);
    writeSlitForm(json, stock);
    json.member("sheet", stock.sheet);
    writeSheets(json, stock, writeShape);
    if (stock.price)
        json.member("price", *stock.price);
    json.endObject();
}

Stock readStock(const JsonCursor &cursor, const StockReaders &readers)
{
    Stock stock;
    stock.id = StockId{readers.readId(cursor.member("id"))};
    stock.name = cursor.member("name").text();
    stock.thickness = cursor.member("thickness").positive();
    stock.density = cursor.member("density").positive();
    stock.tensileStrength = readRated(cursor.member("tensileStrength"));
    stock.flexuralStrength = readRated(cursor.member("flexuralStrength"));
    stock.modulus = readRated(cursor.member("modulus"));
    stock.kerf = cursor.member("kerf").notNegative();
    const JsonCursor clearance = cursor.member("clearance");
    if (const JsonCursor ductile = cursor.member("ductile"); ductile.exists())
        stock.isDuctile = ductile.truth();
    if (const JsonCursor lasting = cursor.member("lastingShare"); lasting.exists()) {
        stock.lastingShare = lasting.positive();
        if (!(stock.lastingShare <= 1.0))
            lasting.failExpected(QT_TRANSLATE_NOOP("Error", "a share above 0, 1 at most"));
    }
    stock.clearance = clearance.coordinate();
    // A slit needs a width, also where it presses.
    if (!(stock.clearance > -stock.thickness))
        clearance.failExpected(QT_TRANSLATE_NOOP("Error", "more than minus the thickness"));
    readSlitForm(cursor, stock);
    const JsonCursor sheet = cursor.member("sheet");
    stock.sheet = sheet.point2();
    if (!(stock.sheet.minCoeff() > 0.0))
        sheet.failExpected(QT_TRANSLATE_NOOP("Error", "a width and a height above 0"));
    readWarehouse(cursor, readers, stock);
    if (const JsonCursor price = cursor.member("price"); price.exists())
        stock.price = price.positive();
    return stock;
}

} // namespace fff::io
