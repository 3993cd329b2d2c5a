// Numbers of stocks, weights and joints that expressions can drive.
#include "core/model/edits.h"
#include "core/model/load_edits.h"
#include "core/operations/driven_owner.h"

namespace fff {

namespace {

struct StockField
{
    const char *key;
    Text label;
    double &(*in)(Stock &stock); // mm
};

const StockField kStockFields[] = {
    {"thickness", FFF_TEXT("Driven", "Thickness"),
     [](Stock &s) -> double & { return s.thickness; }},
    {"clearance", FFF_TEXT("Driven", "Clearance"),
     [](Stock &s) -> double & { return s.clearance; }},
    {"kerf", FFF_TEXT("Driven", "Kerf"), [](Stock &s) -> double & { return s.kerf; }},
    {"sheetWidth", FFF_TEXT("Driven", "Width of a sheet"),
     [](Stock &s) -> double & { return s.sheet.x(); }},
    {"sheetHeight", FFF_TEXT("Driven", "Height of a sheet"),
     [](Stock &s) -> double & { return s.sheet.y(); }},
    {"toolDiameter", FFF_TEXT("Driven", "Diameter of the tool"),
     [](Stock &s) -> double & { return s.toolDiameter; }},
    {"leadIn", FFF_TEXT("Driven", "Lead-in of slits"),
     [](Stock &s) -> double & { return s.leadIn; }},
    {"bumps", FFF_TEXT("Driven", "Bumps in slits"), [](Stock &s) -> double & { return s.bumps; }},
};

std::optional<DrivenNumber> readStock(const Document &document, const DrivenPlace &place)
{
    const Stock *stock = document.find(StockId{place.id});
    const StockField *field = fieldNamed(kStockFields, place.field);
    if (!stock || !field)
        return std::nullopt;
    Stock copy = *stock;
    return DrivenNumber{ValueKind::Length, worthOf(ValueKind::Length, field->in(copy)),
                        field->label};
}

Result<Document> writeStock(Document document, const DrivenPlace &place, const Worth &worth)
{
    Stock next = *document.find(StockId{place.id});
    fieldNamed(kStockFields, place.field)->in(next) = worth.number;
    return setStock(std::move(document), std::move(next));
}

void listStocks(const Document &document, std::vector<DrivenPlace> &places)
{
    for (const auto &stock : document.stocks)
        for (const StockField &field : kStockFields)
            places.push_back(
                {.of = DrivenPlace::Of::Stock, .id = stock->id.value, .field = field.key});
}

std::string nameOfStock(const Document &document, const DrivenPlace &place)
{
    const Stock *stock = document.find(StockId{place.id});
    return stock ? stock->name : std::string();
}

struct LoadField
{
    const char *key;
    Text label;
    ValueKind kind;
    double &(*in)(Load &load);
    bool (*isOf)(const Load &load);
};

bool isWeight(const Load &load)
{
    return !load.isPush();
}
bool isPush(const Load &load)
{
    return load.isPush();
}
bool isAny(const Load &)
{
    return true;
}

/// Forces are plain numbers, N: no unit of an expression is one.
const LoadField kLoadFields[] = {
    {"mass", FFF_TEXT("Driven", "Mass"), ValueKind::Mass,
     [](Load &l) -> double & { return l.mass; }, isWeight},
    {"filled", FFF_TEXT("Driven", "Filled with"), ValueKind::Mass,
     [](Load &l) -> double & { return l.filled; }, isWeight},
    {"height", FFF_TEXT("Driven", "Height"), ValueKind::Length,
     [](Load &l) -> double & { return l.height; }, isWeight},
    {"width", FFF_TEXT("Driven", "Width"), ValueKind::Length,
     [](Load &l) -> double & { return l.width; }, isAny},
    {"x", FFF_TEXT("Driven", "X"), ValueKind::Length,
     [](Load &l) -> double & { return l.position.x(); }, isAny},
    {"y", FFF_TEXT("Driven", "Y"), ValueKind::Length,
     [](Load &l) -> double & { return l.position.y(); }, isAny},
    {"pushX", FFF_TEXT("Driven", "Force along X"), ValueKind::Ratio,
     [](Load &l) -> double & { return l.push.x(); }, isPush},
    {"pushY", FFF_TEXT("Driven", "Force along Y"), ValueKind::Ratio,
     [](Load &l) -> double & { return l.push.y(); }, isPush},
    {"pushZ", FFF_TEXT("Driven", "Force across"), ValueKind::Ratio,
     [](Load &l) -> double & { return l.push.z(); }, isPush},
};

std::optional<DrivenNumber> readLoad(const Document &document, const DrivenPlace &place)
{
    const Load *load = document.find(LoadId{place.id});
    const LoadField *field = fieldNamed(kLoadFields, place.field);
    if (!load || !field || !field->isOf(*load))
        return std::nullopt;
    Load copy = *load;
    return DrivenNumber{field->kind, worthOf(field->kind, field->in(copy)), field->label};
}

Result<Document> writeLoad(Document document, const DrivenPlace &place, const Worth &worth)
{
    Load next = *document.find(LoadId{place.id});
    fieldNamed(kLoadFields, place.field)->in(next) = worth.number;
    return setLoad(std::move(document), next);
}

void listLoads(const Document &document, std::vector<DrivenPlace> &places)
{
    for (const Load &load : document.loads)
        for (const LoadField &field : kLoadFields)
            if (field.isOf(load))
                places.push_back(
                    {.of = DrivenPlace::Of::Load, .id = load.id.value, .field = field.key});
}

std::string nameOfLoad(const Document &document, const DrivenPlace &place)
{
    const Load *load = document.find(LoadId{place.id});
    return load ? load->name : std::string();
}

constexpr const char *kShare = "share";

const JointOverride::Share *shareAt(const Document &document, const DrivenPlace &place)
{
    const JointOverride *joint = document.jointOverride(place.a, place.b);
    const auto index = static_cast<std::size_t>(place.index);
    return joint && place.index >= 0 && index < joint->shares.size() ? &joint->shares[index]
                                                                     : nullptr;
}

std::optional<DrivenNumber> readShare(const Document &document, const DrivenPlace &place)
{
    const JointOverride::Share *share = shareAt(document, place);
    if (!share || place.field != kShare || !(place.a < place.b))
        return std::nullopt;
    return DrivenNumber{ValueKind::Ratio, worthOf(ValueKind::Ratio, share->ofA),
                        FFF_TEXT("Driven", "Meeting point")};
}

Result<Document> writeShare(Document document, const DrivenPlace &place, const Worth &worth)
{
    JointOverride next = *document.jointOverride(place.a, place.b);
    next.shares[static_cast<std::size_t>(place.index)].ofA = worth.number;
    return setJointOverride(std::move(document), std::move(next));
}

void listShares(const Document &document, std::vector<DrivenPlace> &places)
{
    for (const JointOverridePointer &joint : document.jointOverrides)
        for (std::size_t i = 0; i < joint->shares.size(); ++i)
            places.push_back({.of = DrivenPlace::Of::Joint,
                              .a = joint->a,
                              .b = joint->b,
                              .index = static_cast<int>(i),
                              .field = kShare});
}

std::string nameOfJoint(const Document &document, const DrivenPlace &place)
{
    const auto called = [&document](const SectionRef &ref) {
        if (const Section *section = document.find(ref.drawn))
            return section->name;
        const Operation *operation = document.find(ref.operation);
        return operation ? operation->name + '/' + ref.key : ref.key;
    };
    return called(place.a) + " + " + called(place.b);
}

} // namespace

const DrivenOwner kDrivenStocks{readStock, writeStock, listStocks, nameOfStock};
const DrivenOwner kDrivenLoads{readLoad, writeLoad, listLoads, nameOfLoad};
const DrivenOwner kDrivenJoints{readShare, writeShare, listShares, nameOfJoint};

} // namespace fff
