#include "core/model/document.h"

#include <algorithm>
#include <cassert>
#include <tuple>

namespace fff {

namespace {

template <class Pointers>
bool equalValues(const Pointers &a, const Pointers &b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const auto &x, const auto &y) { return x == y || *x == *y; });
}

} // namespace

int Document::indexOf(SectionId id) const
{
    std::size_t from = 0, to = sections.size();
    while (from < to) {
        const std::size_t middle = from + (to - from) / 2;
        if (sections[middle]->id == id)
            return static_cast<int>(middle);
        if (sections[middle]->id < id)
            from = middle + 1;
        else
            to = middle;
    }
    for (std::size_t i = 0; i < sections.size(); ++i) {
        if (sections[i]->id == id)
            return static_cast<int>(i);
    }
    return -1;
}

const Section *Document::find(SectionId id) const
{
    const int index = indexOf(id);
    return index < 0 ? nullptr : sections[static_cast<std::size_t>(index)].get();
}

const Stock *Document::find(StockId id) const
{
    const auto it =
        std::find_if(stocks.begin(), stocks.end(), [id](const auto &s) { return s->id == id; });
    return it == stocks.end() ? nullptr : it->get();
}

const Operation *Document::find(OperationId id) const
{
    const auto it = std::find_if(operations.begin(), operations.end(),
                                 [id](const auto &operation) { return operation->id == id; });
    return it == operations.end() ? nullptr : it->get();
}

const Load *Document::find(LoadId id) const
{
    const auto it =
        std::find_if(loads.begin(), loads.end(), [id](const Load &load) { return load.id == id; });
    return it == loads.end() ? nullptr : &*it;
}

const Template *Document::find(TemplateId id) const
{
    const auto it = std::find_if(templates.begin(), templates.end(),
                                 [id](const TemplatePointer &one) { return one->id == id; });
    return it == templates.end() ? nullptr : it->get();
}

const Blob *Document::findBlob(std::string_view sha256) const
{
    const auto found = std::lower_bound(
        blobs.begin(), blobs.end(), sha256,
        [](const BlobPointer &blob, std::string_view wanted) { return blob->sha256 < wanted; });
    return found != blobs.end() && (*found)->sha256 == sha256 ? found->get() : nullptr;
}

const Stock &Document::stockOf(const Section &section) const
{
    const Stock *stock = find(section.stock);
    assert(stock && "every section's stock is in the document");
    return *stock;
}

const JointOverride *Document::jointOverride(const SectionRef &first,
                                             const SectionRef &second) const
{
    const auto pair = std::minmax(first, second);
    const auto found = std::lower_bound(jointOverrides.begin(), jointOverrides.end(), pair,
                                        [](const JointOverridePointer &joint, const auto &wanted) {
                                            return std::tie(joint->a, joint->b) <
                                                   std::tie(wanted.first, wanted.second);
                                        });
    return found != jointOverrides.end() && (*found)->a == pair.first && (*found)->b == pair.second
               ? found->get()
               : nullptr;
}

bool Document::isSame(const Document &other) const
{
    return sections == other.sections && stocks == other.stocks && operations == other.operations &&
           loads == other.loads && jointOverrides == other.jointOverrides &&
           dimensions == other.dimensions && pins == other.pins && turnings == other.turnings &&
           numbers == other.numbers && values.isSame(other.values) && bindings == other.bindings &&
           templates == other.templates && blobs == other.blobs &&
           currentStock == other.currentStock && opensForAdjusting == other.opensForAdjusting;
}

bool Document::operator==(const Document &other) const
{
    return equalValues(sections, other.sections) && equalValues(stocks, other.stocks) &&
           equalValues(operations, other.operations) && loads == other.loads &&
           equalValues(jointOverrides, other.jointOverrides) && dimensions == other.dimensions &&
           pins == other.pins && turnings == other.turnings && numbers == other.numbers &&
           values == other.values &&
           std::equal(bindings.begin(), bindings.end(), other.bindings.begin(),
                      other.bindings.end(),
                      [](const BindingPointer &a, const BindingPointer &b) {
                          return a == b || a->binding == b->binding;
                      }) &&
           equalValues(templates, other.templates) && equalValues(blobs, other.blobs) &&
           currentStock == other.currentStock && nextId == other.nextId &&
           opensForAdjusting == other.opensForAdjusting;
}

Document newDocument()
{
    Document document;
    Stock stock = birchPlywood();
    stock.id = StockId{document.nextId++};
    document.currentStock = stock.id;
    document.stocks.push_back(std::make_shared<const Stock>(std::move(stock)));
    return document;
}

} // namespace fff
