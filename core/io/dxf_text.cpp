#include "core/io/dxf_text.h"

#include <array>
#include <charconv>
#include <utility>

namespace fff::io {

namespace {

// What others refer to.
constexpr std::uint32_t kModelRecord = 0x20, kPaperRecord = 0x21, kRootDictionary = 0x22,
                        kGroupDictionary = 0x23;
/// Of tables, in their order.
enum DxfTable : std::uint32_t {
    kViewPorts = 1,
    kLineTypes,
    kLayers,
    kStyles,
    kViews,
    kUserSystems,
    kApplications,
    kDimensionStyles,
    kBlockRecords
};

std::string hexadecimal(std::uint32_t handle)
{
    std::array<char, 16> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), handle, 16);
    std::string upper(text.data(), end.ptr);
    for (char &c : upper)
        if (c >= 'a')
            c = static_cast<char>(c - 'a' + 'A');
    return upper;
}

} // namespace

DxfText::DxfText(DxfVersion version, std::span<const std::string> comments, const Box2 &extents,
                 std::span<const DxfLayer> layersToMake, std::size_t length)
    : m_version(version), m_out(length)
{
    for (const std::string &comment : comments)
        group(999, comment);
    header(extents);
    if (isNew()) {
        group(0, "SECTION");
        group(2, "CLASSES");
        group(0, "ENDSEC");
    }
    group(0, "SECTION");
    group(2, "TABLES");
    if (isNew()) {
        table("VPORT", kViewPorts, 0);
        group(0, "ENDTAB");
    }
    lineTypes();
    layers(layersToMake);
    if (isNew())
        otherTables();
    group(0, "ENDSEC");
    blocks();
    group(0, "SECTION");
    group(2, "ENTITIES");
}

void DxfText::group(int code, std::string_view value)
{
    m_out << std::to_string(code) << "\n" << value << "\n";
}

void DxfText::group(int code, int value)
{
    group(code, std::to_string(value));
}

void DxfText::group(int code, double value)
{
    m_out << std::to_string(code) << "\n" << value << "\n";
}

void DxfText::handle()
{
    handle(m_next++);
}

void DxfText::handle(std::uint32_t known)
{
    if (isNew())
        group(5, hexadecimal(known));
}

void DxfText::owner(std::uint32_t known)
{
    if (isNew())
        group(330, hexadecimal(known));
}

void DxfText::subclass(std::string_view name)
{
    if (isNew() && !name.empty())
        group(100, name);
}

void DxfText::header(const Box2 &extents)
{
    const auto variable = [this](std::string_view name, int code, auto value) {
        group(9, name);
        group(code, value);
    };
    const auto corner = [this](std::string_view name, const Vec2 &p) {
        group(9, name);
        group(10, p.x());
        group(20, p.y());
        group(30, 0.0);
    };
    group(0, "SECTION");
    group(2, "HEADER");
    variable("$ACADVER", 1, std::string_view(isNew() ? "AC1015" : "AC1009"));
    if (isNew())
        variable("$HANDSEED", 5, std::string_view("FFFFFFF"));
    variable("$INSUNITS", 70, 4);    // millimetres
    variable("$MEASUREMENT", 70, 1); // metric
    variable("$LUNITS", 70, 2);      // decimal
    corner("$EXTMIN", extents.min);
    corner("$EXTMAX", extents.max);
    group(0, "ENDSEC");
}

void DxfText::table(std::string_view name, std::uint32_t known, int count)
{
    group(0, "TABLE");
    group(2, name);
    handle(known);
    owner(0);
    subclass("AcDbSymbolTable");
    group(70, count);
}

void DxfText::record(std::string_view type, std::uint32_t of, std::string_view kind,
                     std::string_view name)
{
    group(0, type);
    handle();
    owner(of);
    subclass("AcDbSymbolTableRecord");
    subclass(kind);
    group(2, name);
    group(70, 0);
}

void DxfText::lineTypes()
{
    constexpr std::array<std::string_view, 3> kNew = {"ByBlock", "ByLayer", "Continuous"};
    constexpr std::array<std::string_view, 1> kOld = {"CONTINUOUS"};
    const std::span<const std::string_view> names =
        isNew() ? std::span<const std::string_view>(kNew) : std::span<const std::string_view>(kOld);
    table("LTYPE", kLineTypes, static_cast<int>(names.size()));
    for (const std::string_view name : names) {
        record("LTYPE", kLineTypes, "AcDbLinetypeTableRecord", name);
        group(3, name == names.back() ? "Solid line" : "");
        group(72, 65);
        group(73, 0);
        group(40, 0.0);
    }
    group(0, "ENDTAB");
}

void DxfText::layers(std::span<const DxfLayer> all)
{
    table("LAYER", kLayers, static_cast<int>(all.size()) + 1);
    const auto add = [this](const DxfLayer &layer) {
        record("LAYER", kLayers, "AcDbLayerTableRecord", layer.name);
        group(62, layer.colour);
        group(6, isNew() ? "Continuous" : "CONTINUOUS");
    };
    add({"0", 7});
    for (const DxfLayer &layer : all)
        add(layer);
    group(0, "ENDTAB");
}

void DxfText::otherTables()
{
    table("STYLE", kStyles, 1);
    record("STYLE", kStyles, "AcDbTextStyleTableRecord", "Standard");
    group(40, 0.0);
    group(41, 1.0);
    group(50, 0.0);
    group(71, 0);
    group(42, 2.5);
    group(3, "txt");
    group(4, "");
    group(0, "ENDTAB");
    table("VIEW", kViews, 0);
    group(0, "ENDTAB");
    table("UCS", kUserSystems, 0);
    group(0, "ENDTAB");
    table("APPID", kApplications, 1);
    record("APPID", kApplications, "AcDbRegAppTableRecord", "ACAD");
    group(0, "ENDTAB");
    table("DIMSTYLE", kDimensionStyles, 0);
    subclass("AcDbDimStyleTable");
    group(0, "ENDTAB");
    table("BLOCK_RECORD", kBlockRecords, 2);
    for (const auto &[known, name] :
         {std::pair(kModelRecord, "*Model_Space"), std::pair(kPaperRecord, "*Paper_Space")}) {
        group(0, "BLOCK_RECORD");
        handle(known);
        owner(kBlockRecords);
        subclass("AcDbSymbolTableRecord");
        subclass("AcDbBlockTableRecord");
        group(2, name);
    }
    group(0, "ENDTAB");
}

void DxfText::blocks()
{
    group(0, "SECTION");
    group(2, "BLOCKS");
    if (isNew())
        for (const auto &[known, name] :
             {std::pair(kModelRecord, "*Model_Space"), std::pair(kPaperRecord, "*Paper_Space")}) {
            for (const bool isBegin : {true, false}) {
                group(0, isBegin ? "BLOCK" : "ENDBLK");
                handle();
                owner(known);
                subclass("AcDbEntity");
                if (known == kPaperRecord)
                    group(67, 1);
                group(8, "0");
                subclass(isBegin ? "AcDbBlockBegin" : "AcDbBlockEnd");
                if (!isBegin)
                    continue;
                group(2, name);
                group(70, 0);
                for (const int code : {10, 20, 30})
                    group(code, 0.0);
                group(3, name);
                group(1, "");
            }
        }
    group(0, "ENDSEC");
}

void DxfText::objects()
{
    group(0, "SECTION");
    group(2, "OBJECTS");
    group(0, "DICTIONARY");
    handle(kRootDictionary);
    owner(0);
    subclass("AcDbDictionary");
    group(281, 1);
    group(3, "ACAD_GROUP");
    group(350, hexadecimal(kGroupDictionary));
    group(0, "DICTIONARY");
    handle(kGroupDictionary);
    owner(kRootDictionary);
    subclass("AcDbDictionary");
    group(281, 1);
    group(0, "ENDSEC");
}

void DxfText::entity(std::string_view type, std::string_view layer, std::string_view kind)
{
    group(0, type);
    if (isNew()) {
        handle();
        owner(kModelRecord);
        subclass("AcDbEntity");
    }
    group(8, layer);
    subclass(kind);
}

std::string DxfText::take()
{
    group(0, "ENDSEC");
    if (isNew())
        objects();
    group(0, "EOF");
    return m_out.take();
}

} // namespace fff::io
