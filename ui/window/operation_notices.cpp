#include "ui/window/operation_notices.h"

#include "core/session/operation_text.h"
#include "ui/base/message_bar.h"
#include "ui/bench/workbench.h"

#include <algorithm>

namespace fff::ui {

OperationNotices::OperationNotices(Workbench &bench, MessageBar &messages, QObject *parent)
    : QObject(parent), m_bench(bench), m_messages(messages)
{
    connect(&bench.session(), &Session::replaced, this, [this] { m_isAnother = true; });
    connect(&bench.session(), &Session::committedChanged, this, &OperationNotices::follow);
}

void OperationNotices::follow()
{
    const Model &model = m_bench.session().committed();
    std::map<std::int64_t, std::vector<OperationNotice>> now;
    const OperationNotice *news = nullptr;
    const Operation *of = nullptr;
    for (const OperationResultPointer &result : model.evaluation.results) {
        if (result->notices.empty())
            continue;
        const std::int64_t id = result->operation->id.value;
        const auto known = m_known.find(id);
        for (const OperationNotice &notice : result->notices) {
            // What was left out is seen, and said where the operation is.
            const bool isWorth = isFailure(notice) ||
                                 notice.kind == OperationNotice::Kind::StoppedAtMost ||
                                 notice.kind == OperationNotice::Kind::NothingToDo;
            const bool isNew =
                known == m_known.end() ||
                std::none_of(known->second.begin(), known->second.end(),
                             [&](const OperationNotice &n) { return n.kind == notice.kind; });
            if (!isWorth || !isNew)
                continue;
            news = &notice;
            of = result->operation.get();
        }
        now.emplace(id, result->notices);
    }
    m_known = std::move(now);
    // What is offered is of the step that it came with.
    if (!m_told.isEmpty() && m_messages.text() == m_told)
        m_messages.show(MessageBar::Severity::Info, {});
    m_told.clear();
    if (news && !m_isAnother)
        tell(*of, *news);
    m_isAnother = false;
}

void OperationNotices::tell(const Operation &operation, const OperationNotice &notice)
{
    std::vector<MessageBar::Verb> verbs;
    const OperationId id = operation.id;
    if (notice.kind == OperationNotice::Kind::InputMissing) {
        const std::string role = notice.role;
        const QString choose = notice.name.empty() ? tr("Choose") : tr("Choose another");
        verbs.push_back({choose, [this, id, role] {
                             m_bench.selectOperation(id);
                             m_bench.run(QStringLiteral("operation.choose"), {{"role", role}});
                         }});
    } else {
        verbs.push_back({tr("Show it"), [this, id] { m_bench.selectOperation(id); }});
    }
    const OperationKind *kind = operationKind(operation.kind);
    const ParameterSpec *most = kind ? kind->parameter("most") : nullptr;
    if (notice.kind == OperationNotice::Kind::StoppedAtMost && most) {
        const double allowed = std::min(most->most, 2.0 * notice.count);
        verbs = {{tr("Allow more"),
                  [this, id, allowed] {
                      m_bench.selectOperation(id);
                      m_bench.run(QStringLiteral("operation.change"),
                                  {{"most", std::to_string(static_cast<int>(allowed))}});
                  }},
                 {tr("Keep it"), [] {}}};
    } else {
        verbs.push_back({tr("Undo"), [this] { m_bench.run(QStringLiteral("edit.undo")); }});
    }
    m_messages.show(isFailure(notice) ? MessageBar::Severity::Error : MessageBar::Severity::Warning,
                    {noticeText(notice, operation)}, std::move(verbs));
    m_told = m_messages.text();
}

} // namespace fff::ui
