#include "core/operations/copying.h"

#include "core/assembly/crossing.h"
#include "core/model/instance_key.h"
#include "core/operations/images.h"

#include <algorithm>
#include <cctype>

namespace fff {

namespace {

bool meets(const Section &a, const Section &b)
{
    return worldBounds(*a.shape, a.frame).intersects(worldBounds(*b.shape, b.frame)) &&
           !findCrossing(*a.shape, a.frame, *b.shape, b.frame).overlaps.empty();
}

/// The root and those that it is on, up to the first.
std::vector<SectionRef> lineageOf(const std::vector<SectionPointer> &all, const Section &root)
{
    std::vector<SectionRef> lineage{root.ref()};
    const auto isKnown = [&lineage](const SectionRef &ref) {
        return std::find(lineage.begin(), lineage.end(), ref) != lineage.end();
    };
    for (const Section *section = &root; section && section->parent;) {
        const SectionRef &parent = section->parent->section;
        if (isKnown(parent))
            break;
        lineage.push_back(parent);
        const auto it = std::find_if(all.begin(), all.end(), [&parent](const SectionPointer &s) {
            return s->ref() == parent;
        });
        section = it == all.end() ? nullptr : it->get();
    }
    return lineage;
}

/// Where a section is held by that which it is on.
Vec3 attachedAt(const Section &section, const Section &host)
{
    if (!section.parent)
        return section.frame.toWorld(section.shape->centroid());
    return host.frame.toWorld(0.5 * (section.parent->slitFrom + section.parent->slitTo));
}

} // namespace

Branch branchOf(const SectionPointer &section)
{
    return {{{section, {}, -1}}};
}

Branch wholeBranchOf(OperationContext &context, const SectionPointer &section,
                     const SectionPointer &root)
{
    Branch branch = branchOf(section);
    const std::vector<SectionPointer> &all = context.all();
    const std::vector<SectionRef> lineage =
        root ? lineageOf(all, *root) : std::vector<SectionRef>();
    std::vector<SectionPointer> rest;
    for (const SectionPointer &other : all)
        if (other != section &&
            std::find(lineage.begin(), lineage.end(), other->ref()) == lineage.end())
            rest.push_back(other);
    for (std::size_t i = 0; i < branch.members.size(); ++i) {
        const SectionPointer host = branch.members[i].section; // the list grows
        const auto isOnHost = [&](const SectionPointer &other) {
            return other->parent ? other->parent->section == host->ref()
                                 : meets(*other, *host) && !(root && meets(*other, *root));
        };
        const auto end =
            std::stable_partition(rest.begin(), rest.end(),
                                  [&](const SectionPointer &other) { return !isOnHost(other); });
        for (auto it = end; it != rest.end(); ++it)
            branch.members.push_back({*it, keyOfSection((*it)->ref()), static_cast<int>(i)});
        rest.erase(end, rest.end());
    }
    return branch;
}

std::string copiedName(const std::string &name, const std::string &number)
{
    const bool endsInDigit =
        !name.empty() && std::isdigit(static_cast<unsigned char>(name.back())) != 0;
    std::string copied = name;
    return copied.append(endsInDigit ? "." : " ").append(number);
}

ShapeMap shapeOf(OperationContext &context, const std::string &key)
{
    return [&context, key](const ShapePointer &shape, const PlaneMap &map) {
        Result<ShapePointer> next = mappedShape(shape, map);
        if (const std::optional<ShapePointer> made = context.made(next))
            next = context.kept(key, *made);
        return next;
    };
}

bool addCopy(OperationContext &context, const Branch &branch, const Copy &copy)
{
    const std::size_t count = branch.members.size();
    std::vector<char> isMade(count, char(false));
    std::vector<Vec3> carried(count, Vec3::Zero()); // by the stretch
    bool isWhole = true;
    for (std::size_t i = 0; i < count; ++i) {
        const Branch::Member &member = branch.members[i];
        const auto host = static_cast<std::size_t>(std::max(member.parent, 0));
        if (i > 0 && !isMade[host])
            continue;
        const std::string key = i == 0 ? copy.key : keyBelow(copy.key, member.key);
        Result<Section> section = copy.section;
        if (i > 0) {
            carried[i] =
                host > 0
                    ? carried[host]
                    : Vec3(copy.stretch * (attachedAt(*member.section, *branch.members[0].section) -
                                           copy.stretchedFrom));
            const Similarity placement = copy.placement * Similarity::moved(carried[i]);
            section = transformed(asCopy(*member.section), placement, shapeOf(context, key));
            if (section && section->parent) {
                const std::string &below = branch.members[host].key;
                section->parent = transformed(*section->parent, placement);
                section->parent->section = SectionRef(
                    context.operation().id, host > 0 ? keyBelow(copy.key, below) : copy.key);
            }
        }
        if (!section) {
            isWhole = false;
            continue;
        }
        section->name = copiedName(member.section->name, copy.number);
        // What is hidden takes along what is on it.
        isMade[i] = !context.isHidden(key);
        context.add(key, *std::move(section));
    }
    return isWhole;
}

} // namespace fff
