#include "core/model/edits.h"

#include "core/base/tolerances.h"
#include "core/geometry/similarity.h"
#include "core/model/dimensions.h"
#include "core/model/figures.h"
#include "core/model/naming.h"
#include "core/model/sheet_edits.h"

#include <algorithm>
#include <functional>

namespace fff {

namespace {

template <class Tag>
tl::unexpected<Error> unknown(Id<Tag> id)
{
    return failure(ErrorCode::UnknownReference, std::to_string(id.value),
                   {std::to_string(id.value)});
}

/// Copies the section, lets `change` alter the copy and puts it in place, unless nothing changed.
template <class Change>
Result<Document> changeSection(Document document, SectionId id, Change change)
{
    const int index = document.indexOf(id);
    if (index < 0)
        return unknown(id);
    SectionPointer &pointer = document.sections[static_cast<std::size_t>(index)];
    Section next = *pointer;
    change(next);
    if (next.shape != pointer->shape) {
        followPoints(document, id, *pointer->shape, *next.shape);
        std::erase_if(next.figures, [&next](const Figure &figure) {
            return boundaryOf(*next.shape, figure) < 0;
        });
    }
    if (next.shape != pointer->shape || !(next == *pointer))
        pointer = std::make_shared<const Section>(std::move(next));
    return document;
}

/// Operations that read these sections will speak of them by the names that they have now.
void noteNames(Document &document, std::span<const SectionId> ids)
{
    for (OperationPointer &pointer : document.operations) {
        Operation next = *pointer;
        for (auto &[role, inputs] : next.inputs)
            for (OperationInput &input : inputs)
                if (std::find(ids.begin(), ids.end(), input.section.drawn) != ids.end())
                    input.name = document.find(input.section.drawn)->name;
        if (!(next == *pointer))
            pointer = std::make_shared<const Operation>(std::move(next));
    }
}

/// What is known of it besides what it is: the sheets that there are, what machines make of it.
const char *invalidWarehouse(const Stock &s)
{
    if (s.nominalThickness && !(*s.nominalThickness > 0.0 && *s.nominalThickness <= kMaxCoordinate))
        return "nominalThickness";
    for (std::size_t i = 0; i < s.kerfs.size(); ++i)
        if (!(s.kerfs[i].kerf >= 0.0 && s.kerfs[i].kerf <= kMaxCoordinate) ||
            s.kerfs[i].machine.empty() || (i > 0 && s.kerfs[i - 1].machine >= s.kerfs[i].machine))
            return "kerfs";
    if (s.sheetCount && (*s.sheetCount < 1 || *s.sheetCount > kMostSheets))
        return "sheetCount";
    int count = 0;
    for (const SpareSheet &spare : s.spares) {
        if (!isUsable(spare))
            return "spares";
        count += spare.count;
    }
    return s.spares.size() > kMostSpareKinds || count > kMostSpares ? "spares" : nullptr;
}

/// The first field of a stock that no sheet can have, or null.
const char *invalidField(const Stock &s)
{
    const auto positive = [](double v) { return v > 0.0 && v <= kMaxCoordinate; };
    const auto ratedOrNone = [&](const std::optional<double> &v) { return !v || positive(*v); };
    if (!positive(s.thickness))
        return "thickness";
    if (!positive(s.density))
        return "density";
    if (!ratedOrNone(s.tensileStrength))
        return "tensileStrength";
    if (!ratedOrNone(s.flexuralStrength))
        return "flexuralStrength";
    if (!ratedOrNone(s.modulus))
        return "modulus";
    if (!(s.lastingShare > 0.0 && s.lastingShare <= 1.0))
        return "lastingShare";
    if (!(s.kerf >= 0.0 && s.kerf <= kMaxCoordinate))
        return "kerf";
    // A slit needs a width, also where it presses: at a right angle, thickness + clearance.
    if (!(s.clearance > -s.thickness && s.clearance <= kMaxCoordinate))
        return "clearance";
    if (!positive(s.toolDiameter))
        return "toolDiameter";
    const auto lengthOrNone = [](double v) { return v >= 0.0 && v <= kMaxCoordinate; };
    if (!lengthOrNone(s.leadIn))
        return "leadIn";
    if (!lengthOrNone(s.bumps))
        return "bumps";
    if (!positive(s.sheet.x()) || !positive(s.sheet.y()))
        return "sheet";
    return invalidWarehouse(s);
}

} // namespace

Result<Document> addSection(Document document, NewSection section)
{
    std::vector<NewSection> one;
    one.push_back(std::move(section));
    return addSections(std::move(document), std::move(one));
}

Result<Document> addSections(Document document, std::vector<NewSection> sections)
{
    // A list that grew by itself would take up twice the room, in every undo step.
    document.sections.reserve(document.sections.size() + sections.size());
    for (NewSection &section : sections) {
        if (!section.shape)
            return failure(ErrorCode::EmptyContour, section.name);
        const StockId stock = section.stock.isValid() ? section.stock : document.currentStock;
        if (!document.find(stock))
            return unknown(stock);
        Section next;
        next.id = SectionId{document.nextId++};
        next.name = section.name.empty() ? freeSectionName(document) : std::move(section.name);
        next.parent = std::move(section.parent);
        next.shape = std::move(section.shape);
        next.symmetry = section.symmetry;
        next.frame = section.frame;
        next.stock = stock;
        document.sections.push_back(std::make_shared<const Section>(std::move(next)));
    }
    return document;
}

namespace {

/// What lies on a section that goes stays where it is, in the world; a mesh is let go by it.
void leaveTemplates(Document &document, const std::vector<SectionPointer> &before,
                    const std::function<bool(SectionId)> &isRemoved)
{
    for (TemplatePointer &pointer : document.templates) {
        Template next = *pointer;
        std::erase_if(next.magnets,
                      [&](const Magnet &magnet) { return isRemoved(magnet.section.drawn); });
        if (isRemoved(next.on.drawn)) {
            const auto ground =
                std::find_if(before.begin(), before.end(), [&next](const SectionPointer &section) {
                    return section->id == next.on.drawn;
                });
            next.frame = placed(next.frame, placementOf((*ground)->frame));
            next.on = {};
        }
        if (next != *pointer)
            pointer = std::make_shared<const Template>(std::move(next));
    }
}

} // namespace

Result<Document> removeSections(Document document, std::span<const SectionId> ids)
{
    const auto isRemoved = [&](SectionId id) {
        return std::find(ids.begin(), ids.end(), id) != ids.end();
    };
    for (SectionId id : ids) {
        if (!document.find(id))
            return unknown(id);
    }
    noteNames(document, ids);
    const std::vector<SectionPointer> before = document.sections;
    std::erase_if(document.sections, [&](const SectionPointer &s) { return isRemoved(s->id); });
    std::erase_if(document.loads, [&](const Load &w) { return isRemoved(w.section.drawn); });
    std::erase_if(document.dimensions, [&](const Dimension &dimension) {
        return isRemoved(dimension.from.section.drawn) || isRemoved(dimension.to.section.drawn);
    });
    std::erase_if(document.jointOverrides, [&](const JointOverridePointer &joint) {
        return isRemoved(joint->a.drawn) || isRemoved(joint->b.drawn);
    });
    forgetSheetWishes(document,
                      [&](const SectionRef &section) { return isRemoved(section.drawn); });
    leaveTemplates(document, before, isRemoved);
    for (SectionPointer &pointer : document.sections) {
        if (pointer->parent && isRemoved(pointer->parent->section.drawn)) {
            Section orphan = *pointer;
            orphan.parent.reset();
            pointer = std::make_shared<const Section>(std::move(orphan));
        }
    }
    return document;
}

Result<Document> moveSection(Document document, SectionId id, const Frame &frame)
{
    return changeSection(std::move(document), id, [&](Section &s) { s.frame = frame; });
}

Document moveAll(Document document, const Vec3 &way)
{
    if (way.isZero())
        return document;
    for (SectionPointer &pointer : document.sections) {
        Section next = *pointer;
        next.frame.origin += way;
        pointer = std::make_shared<const Section>(std::move(next));
    }
    for (TemplatePointer &pointer : document.templates) {
        if (pointer->on != SectionRef())
            continue;
        Template next = *pointer;
        next.frame.origin += way;
        pointer = std::make_shared<const Template>(std::move(next));
    }
    return document;
}

Result<Document> setShape(Document document, SectionId id, ShapePointer shape)
{
    if (!shape)
        return failure(ErrorCode::EmptyContour, std::to_string(id.value));
    return changeSection(std::move(document), id, [&](Section &s) { s.shape = std::move(shape); });
}

Result<Document> renameSection(Document document, SectionId id, std::string name)
{
    return changeSection(std::move(document), id, [&](Section &s) { s.name = std::move(name); });
}

Result<Document> setSectionStock(Document document, SectionId id, StockId stock)
{
    if (!document.find(stock))
        return unknown(stock);
    return changeSection(std::move(document), id, [&](Section &s) { s.stock = stock; });
}

Result<Document> addStock(Document document, Stock stock)
{
    if (const char *field = invalidField(stock))
        return failure(ErrorCode::BadValue, field);
    stock.id = StockId{document.nextId++};
    document.currentStock = stock.id;
    document.stocks.push_back(std::make_shared<const Stock>(std::move(stock)));
    return document;
}

Result<Document> setStock(Document document, Stock stock)
{
    if (const char *field = invalidField(stock))
        return failure(ErrorCode::BadValue, field);
    for (std::shared_ptr<const Stock> &pointer : document.stocks) {
        if (pointer->id != stock.id)
            continue;
        if (!(*pointer == stock))
            pointer = std::make_shared<const Stock>(std::move(stock));
        return document;
    }
    return unknown(stock.id);
}

Result<Document> setCurrentStock(Document document, StockId id)
{
    if (!document.find(id))
        return unknown(id);
    document.currentStock = id;
    return document;
}

Result<Document> removeStock(Document document, StockId id, StockId replacement)
{
    if (!document.find(id))
        return unknown(id);
    if (!document.find(replacement))
        return unknown(replacement);
    if (id == replacement)
        return failure(ErrorCode::BadValue, "replacement");
    for (SectionPointer &pointer : document.sections) {
        if (pointer->stock != id)
            continue;
        Section next = *pointer;
        next.stock = replacement;
        pointer = std::make_shared<const Section>(std::move(next));
    }
    for (OperationPointer &pointer : document.operations) {
        Operation next = *pointer;
        for (auto &[key, exception] : next.exceptions)
            if (exception.stock == id)
                exception.stock = replacement;
        if (!(next == *pointer))
            pointer = std::make_shared<const Operation>(std::move(next));
    }
    if (document.currentStock == id)
        document.currentStock = replacement;
    std::erase_if(document.stocks, [id](const auto &stock) { return stock->id == id; });
    return document;
}

Result<Document> setJointOverride(Document document, JointOverride wanted)
{
    for (const SectionRef &ref : {wanted.a, wanted.b})
        if (ref.drawn.isValid() && !document.find(ref.drawn))
            return unknown(ref.drawn);
    if (!(wanted.a < wanted.b))
        return failure(ErrorCode::BadValue, "sections");
    for (const JointOverride::Share &share : wanted.shares)
        if (!(share.ofA >= kLeastShare && share.ofA <= 1.0 - kLeastShare))
            return failure(ErrorCode::BadValue, "share");
    if (wanted.opens) {
        const double length = wanted.opens->norm();
        if (!(length > 0.0 && std::isfinite(length)))
            return failure(ErrorCode::BadValue, "opens");
        *wanted.opens /= length;
    }
    auto &all = document.jointOverrides;
    const auto place = std::lower_bound(
        all.begin(), all.end(), wanted, [](const JointOverridePointer &joint, const auto &other) {
            return std::tie(joint->a, joint->b) < std::tie(other.a, other.b);
        });
    const bool isKnown = place != all.end() && (*place)->a == wanted.a && (*place)->b == wanted.b;
    if (isKnown && **place == wanted)
        return document;
    if (isKnown && wanted.isEmpty())
        all.erase(place);
    else if (isKnown)
        *place = std::make_shared<const JointOverride>(std::move(wanted));
    else if (!wanted.isEmpty())
        all.insert(place, std::make_shared<const JointOverride>(std::move(wanted)));
    return document;
}

Document addBlob(Document document, BlobPointer blob)
{
    if (document.findBlob(blob->sha256))
        return document;
    const auto place = std::upper_bound(
        document.blobs.begin(), document.blobs.end(), blob,
        [](const BlobPointer &a, const BlobPointer &b) { return a->sha256 < b->sha256; });
    document.blobs.insert(place, std::move(blob));
    return document;
}

} // namespace fff
