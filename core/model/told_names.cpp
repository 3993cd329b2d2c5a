#include "core/model/told_names.h"

#include "core/model/bindings.h"

#include <memory>
#include <utility>
#include <vector>

namespace fff {

namespace {

/// Behind the last blank; empty: there is no number.
std::string numberBehind(const std::string &name)
{
    const std::size_t blank = name.rfind(' ');
    if (blank == name.npos || blank + 1 == name.size() ||
        name.find_first_not_of("0123456789", blank + 1) != name.npos)
        return {};
    return name.substr(blank);
}

std::string toldName(const std::string &name, const Told &told)
{
    if (name.empty())
        return name;
    const std::string number = numberBehind(name);
    return told(name.substr(0, name.size() - number.size())) + number;
}

template <class Thing>
void tellAll(std::vector<std::shared_ptr<const Thing>> &things, const Told &told)
{
    for (std::shared_ptr<const Thing> &thing : things) {
        Thing next = *thing;
        next.name = toldName(thing->name, told);
        if (next.name != thing->name)
            thing = std::make_shared<const Thing>(std::move(next));
    }
}

Document withValueTold(Document document, ValueId id, const Told &told)
{
    Value value = *document.values.find(id);
    value.note = toldName(value.note, told);
    value.group = toldName(value.group, told);
    if (Understood<Document> next = changeValue(document, value))
        document = *std::move(next);
    if (Understood<Document> next = renameValue(document, id, toldName(value.name, told)))
        document = *std::move(next);
    return document;
}

} // namespace

Document withNamesTold(Document document, const Told &told)
{
    tellAll(document.sections, told);
    tellAll(document.operations, told);
    for (Load &load : document.loads)
        load.name = toldName(load.name, told);
    tellAll(document.values.presets, told);
    std::vector<ValueId> values;
    for (const ValuePointer &known : document.values.list)
        values.push_back(known->value.id);
    for (const ValueId id : values)
        document = withValueTold(std::move(document), id, told);
    return document;
}

} // namespace fff
