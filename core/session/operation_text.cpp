#include "core/session/operation_text.h"

#include "core/operations/operation_words.h"
#include "core/session/message_text.h"

#include <QCoreApplication>

#include <algorithm>

namespace fff {

namespace {

struct OperationNoticeTexts
{
    Q_DECLARE_TR_FUNCTIONS(OperationNotice)
};

/// What an input is called in the panel.
QString inputName(const Operation &operation, const std::string &role)
{
    const OperationKind *kind = operationKind(operation.kind);
    const InputSpec *spec = kind ? kind->input(role) : nullptr;
    return spec ? operationText(spec->label) : QString::fromStdString(role);
}

} // namespace

QString operationText(const char *text)
{
    return messageText(operationWord(text));
}

QString kindName(const Operation &operation)
{
    const OperationKind *kind = operationKind(operation.kind);
    return kind ? operationText(kind->name) : QString::fromStdString(operation.kind);
}

QString valueText(const ParameterSpec &spec, const std::optional<ParameterValue> &value)
{
    return argumentText(valueWords(spec, value));
}

QString noticeText(const OperationNotice &notice, const Operation &operation)
{
    using Kind = OperationNotice::Kind;
    const QString name = QString::fromStdString(operation.name);
    switch (notice.kind) {
    case Kind::InputMissing:
        if (notice.name.empty())
            //: %1 is the name of an operation, %2 what it asks for: "Along"
            return OperationNoticeTexts::tr("%1 makes nothing yet: choose its “%2”.")
                .arg(name, inputName(operation, notice.role));
        //: %1 is the name of an operation, %2 that of a section
        return OperationNoticeTexts::tr("%1 has lost its section “%2”, which was deleted. It makes "
                                        "nothing until another one is chosen.")
            .arg(name, QString::fromStdString(notice.name));
    case Kind::InputsApart:
        //: %1 is the name of an operation
        return OperationNoticeTexts::tr("%1 makes nothing: its sections do not cross each other.")
            .arg(name);
    case Kind::NothingFits:
        //: %1 is the name of an operation
        return OperationNoticeTexts::tr("%1 makes nothing: there is no room within its range.")
            .arg(name);
    case Kind::NothingToDo:
        //: %1 is the name of an operation
        return OperationNoticeTexts::tr(
                   "%1 has nothing to divide: the section fits into a single cell.")
            .arg(name);
    case Kind::Failed:
        //: %1 is the name of an operation
        return OperationNoticeTexts::tr("%1 could not be worked out: its sections are missing.")
            .arg(name);
    case Kind::StoppedAtMost:
        //: %1 is the name of an operation
        return (notice.count == 1
                    ? OperationNoticeTexts::tr("%1 stopped at 1 section.")
                    //: %1 is the name of an operation
                    : OperationNoticeTexts::tr("%1 stopped at %n sections.", nullptr, notice.count))
            .arg(name);
    case Kind::LeftOut:
        //: %1 is the name of an operation
        return (notice.count == 1
                    ? OperationNoticeTexts::tr(
                          "1 section of %1 was left out, as there is nothing to hold it.")
                    //: %1 is the name of an operation
                    : OperationNoticeTexts::tr(
                          "%n sections of %1 were left out, as there is nothing to hold "
                          "them.",
                          nullptr, notice.count))
            .arg(name);
    case Kind::NoTemplate:
        //: %1 is the name of an operation
        return OperationNoticeTexts::tr(
                   "%1 makes nothing: its template is gone or its file is missing.")
            .arg(name);
    case Kind::Slivers:
        //: %1 is the name of an operation
        return (notice.count == 1 ? OperationNoticeTexts::tr("1 small piece of %1 was left out.")
                                  //: %1 is the name of an operation
                                  : OperationNoticeTexts::tr("%n small pieces of %1 were left out.",
                                                             nullptr, notice.count))
            .arg(name);
    }
    return {};
}

int countOf(const OperationResult &result)
{
    // What it makes of sections that are there is not counted with what it adds.
    if (!result.sections.empty())
        return static_cast<int>(result.sections.size());
    const auto changed = std::count_if(result.changed.begin(), result.changed.end(),
                                       [](const auto &change) { return change.second != nullptr; });
    return static_cast<int>(changed);
}

bool isFailure(const OperationNotice &notice)
{
    using Kind = OperationNotice::Kind;
    return notice.kind != Kind::StoppedAtMost && notice.kind != Kind::NothingToDo &&
           notice.kind != Kind::LeftOut && notice.kind != Kind::Slivers;
}

} // namespace fff
