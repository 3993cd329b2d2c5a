// The pure edits: each takes a document and returns the next one. Sections that an edit does not
// touch keep their pointers; an edit that changes nothing returns the document as it came (isSame).
// Errors of all: UnknownReference, place = the id, when a section, stock or weight is not there.
#pragma once

#include "core/model/document.h"

#include <span>
#include <vector>

namespace fff {

struct NewSection
{
    std::string name; // empty: freeSectionName() in English
    std::optional<Parent> parent;
    ShapePointer shape;
    Frame frame;
    StockId stock; // invalid: the document's current one
    std::optional<MirrorAxis> symmetry = {};
};

/// Appends a section; its id is the document's nextId. Errors also: UnknownReference of its stock,
/// EmptyContour without a shape.
Result<Document> addSection(Document document, NewSection section);
/// The same of many, in their order. Those without a name cost a look at all names each.
Result<Document> addSections(Document document, std::vector<NewSection> sections);
/// Removes sections; children of a removed one stay, as sections without a parent; weights on it,
/// dimensions and what was wanted of its joints go. Operations that read it keep its name.
Result<Document> removeSections(Document document, std::span<const SectionId> ids);
Result<Document> moveSection(Document document, SectionId id, const Frame &frame);
/// All sections by the same way in the world, mm.
Document moveAll(Document document, const Vec3 &way);
Result<Document> setShape(Document document, SectionId id, ShapePointer shape);
Result<Document> renameSection(Document document, SectionId id, std::string name);
Result<Document> setSectionStock(Document document, SectionId id, StockId stock);

/// Appends a stock (its id is given) and makes it the current one.
Result<Document> addStock(Document document, Stock stock);
/// Replaces the stock with the same id. BadValue, place "thickness" and so on, when not positive.
Result<Document> setStock(Document document, Stock stock);
Result<Document> setCurrentStock(Document document, StockId id);
/// Takes a stock out; sections of it, and the next ones, are of `replacement` then. BadValue, place
/// "replacement", when that is the stock itself.
Result<Document> removeStock(Document document, StockId id, StockId replacement);

/// Replaces what was wanted of the joint of these two sections; an empty one takes it away.
/// BadValue, place "sections" unless a < b, "share" or "opens" for a share that is none and a
/// direction without a length.
Result<Document> setJointOverride(Document document, JointOverride wanted);

/// Nothing changes when its bytes are there already, whatever they were called.
Document addBlob(Document document, BlobPointer blob);

} // namespace fff
