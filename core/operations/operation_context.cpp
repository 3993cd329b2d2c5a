#include "core/operations/operation_context.h"

#include "core/model/instance_key.h"
#include "core/operations/operation_kind.h"

#include <algorithm>
#include <cassert>

namespace fff {

OperationContext::OperationContext(const Document &document, const OperationKind &kind,
                                   const OperationPointer &operation, const SectionLookup &above,
                                   const OperationResult *previous)
    : m_document(document), m_kind(kind), m_above(above), m_previous(previous)
{
    m_result.operation = operation;
}

std::vector<SectionPointer> OperationContext::inputs(std::string_view role)
{
    std::vector<SectionPointer> sections;
    const auto it = operation().inputs.find(std::string(role));
    static const std::vector<OperationInput> none;
    const std::vector<OperationInput> &wanted = it == operation().inputs.end() ? none : it->second;
    const InputSpec *spec = m_kind.input(role);
    assert(spec && "a role of this kind");
    for (const OperationInput &input : wanted) {
        sections.push_back(find(input.section));
        if (!sections.back()) {
            notice({OperationNotice::Kind::InputMissing, std::string(role), input.name});
            return {};
        }
    }
    if (static_cast<int>(sections.size()) < spec->least)
        notice({OperationNotice::Kind::InputMissing, std::string(role)});
    return sections;
}

SectionPointer OperationContext::input(std::string_view role)
{
    const std::vector<SectionPointer> sections = inputs(role);
    return sections.empty() ? nullptr : sections.front();
}

SectionPointer OperationContext::find(const SectionRef &ref)
{
    SectionPointer section = m_above.find(ref);
    if (m_read.insert(ref).second)
        m_result.readSections.emplace_back(ref, section);
    return section;
}

const Stock &OperationContext::stock(StockId id)
{
    const auto it = std::find_if(m_document.stocks.begin(), m_document.stocks.end(),
                                 [id](const auto &stock) { return stock->id == id; });
    assert(it != m_document.stocks.end() && "every section's stock is in the document");
    const auto known = std::find_if(m_result.readStocks.begin(), m_result.readStocks.end(),
                                    [id](const auto &read) { return read.first == id; });
    if (known == m_result.readStocks.end())
        m_result.readStocks.emplace_back(id, *it);
    return **it;
}

TemplatePointer OperationContext::subject()
{
    const auto it = std::find_if(
        m_document.templates.begin(), m_document.templates.end(),
        [id = operation().subject](const TemplatePointer &one) { return one->id == id; });
    m_result.readTemplate = it == m_document.templates.end() ? nullptr : *it;
    return m_result.readTemplate;
}

StockId OperationContext::stockOfNew()
{
    const StockId wanted = operation().stock;
    return m_document.find(wanted) ? wanted : m_document.stocks.front()->id;
}

const std::vector<SectionPointer> &OperationContext::all()
{
    if (!m_result.readAll)
        m_result.readAll = std::make_shared<const std::vector<SectionPointer>>(m_above.sections());
    return *m_result.readAll;
}

ParameterValue OperationContext::value(std::string_view key) const
{
    const ParameterSpec *spec = m_kind.parameter(key);
    assert(spec && !spec->isFree && "a parameter of this kind that has a value");
    return *valueOf(*spec, operation());
}

bool OperationContext::isOn(std::string_view key) const
{
    return std::get<bool>(value(key));
}

double OperationContext::number(std::string_view key) const
{
    return std::get<double>(value(key));
}

int OperationContext::count(std::string_view key) const
{
    return static_cast<int>(number(key));
}

std::string OperationContext::choice(std::string_view key) const
{
    return std::get<std::string>(value(key));
}

std::optional<double> OperationContext::freeNumber(std::string_view key) const
{
    const ParameterSpec *spec = m_kind.parameter(key);
    assert(spec && spec->isFree && "a free parameter of this kind");
    const std::optional<ParameterValue> value = valueOf(*spec, operation());
    return value ? std::optional(std::get<double>(*value)) : std::nullopt;
}

SectionPointer OperationContext::previous(const std::string &key) const
{
    const int index = m_previous ? indexOfKey(m_previous->sections, key) : -1;
    return index < 0 ? nullptr : m_previous->sections[static_cast<std::size_t>(index)];
}

Result<ShapePointer> OperationContext::shape(const std::string &key, Contour contour,
                                             std::vector<Contour> holes)
{
    const Result<ShapePointer> made = Shape::make(std::move(contour), std::move(holes));
    return made ? Result<ShapePointer>(kept(key, *made)) : made;
}

ShapePointer OperationContext::kept(const std::string &key, ShapePointer shape)
{
    const SectionPointer before = previous(key);
    return before && *before->shape == *shape ? before->shape : shape;
}

ShapePointer OperationContext::keptOfAny(ShapePointer shape)
{
    if (m_previous && m_shapesBefore.empty())
        for (const SectionPointer &section : m_previous->sections)
            m_shapesBefore.insert(section->shape);
    for (const ShapePointer &before : m_shapesBefore)
        if (*before == *shape)
            return before;
    return shape;
}

bool OperationContext::isHidden(const std::string &key) const
{
    const auto exception = operation().exceptions.find(key);
    return exception != operation().exceptions.end() &&
           exception->second.state == Exception::State::Hidden;
}

void OperationContext::add(std::string key, Section section)
{
    const auto exception = operation().exceptions.find(key);
    if (exception != operation().exceptions.end()) {
        if (exception->second.state != Exception::State::Made)
            return;
        const StockId stock = exception->second.stock;
        if (stock.isValid() && m_document.find(stock))
            section.stock = stock;
    }
    SectionPointer before = previous(key);
    section.id = {};
    section.made = SectionRef(operation().id, std::move(key));
    const bool isSame = before && section.shape == before->shape && section == *before;
    m_result.sections.push_back(isSame ? std::move(before)
                                       : std::make_shared<const Section>(std::move(section)));
}

void OperationContext::setImage(const std::string &key, const SectionRef &of, bool isMirrored)
{
    m_result.images.insert_or_assign(key, OperationResult::Image{of, isMirrored});
}

void OperationContext::setMirror(const SectionRef &ref, const Halfplane &line)
{
    m_result.mirrors.insert_or_assign(ref, line);
}

void OperationContext::change(const SectionRef &ref, SectionPointer section)
{
    if (m_previous && section) {
        for (const auto &[changedRef, before] : m_previous->changed)
            if (changedRef == ref && before && before->shape == section->shape &&
                *before == *section)
                section = before;
    }
    m_result.changed.emplace_back(ref, std::move(section));
}

void OperationContext::notice(OperationNotice notice)
{
    m_result.notices.push_back(std::move(notice));
}

void OperationContext::noticeFailure(const Error &error)
{
    if (error.code == ErrorCode::EmptyContour || error.code == ErrorCode::BadValue)
        return;
    const OperationNotice failed{.kind = OperationNotice::Kind::Failed};
    if (std::find(m_result.notices.begin(), m_result.notices.end(), failed) ==
        m_result.notices.end())
        m_result.notices.push_back(failed);
}

void OperationContext::found(std::string_view key, double value)
{
    m_result.found.insert_or_assign(std::string(key), value);
}

void OperationContext::setTrack(std::vector<std::pair<Vec3, double>> track)
{
    m_result.track = std::move(track);
}

OperationResult OperationContext::take()
{
    std::sort(m_result.sections.begin(), m_result.sections.end(),
              [](const SectionPointer &a, const SectionPointer &b) {
                  return isKeyBefore(a->made.key, b->made.key);
              });
    return std::move(m_result);
}

} // namespace fff
