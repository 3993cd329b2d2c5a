#include "ui/bench/hint_text.h"

#include "core/session/message_text.h"

#include <QCoreApplication>

namespace fff::ui {

namespace {

struct HintText
{
    Q_DECLARE_TR_FUNCTIONS(Hint)
};

} // namespace

QString hintSentence(const Hint &hint, const QString &undoKeys)
{
    const QString sentence = messageText(hint.words, metricUnits(), NameStyle::Bold);
    if (!hint.offersUndo || undoKeys.isEmpty())
        return sentence;
    //: %1 is what is pressed; follows "The contour crosses itself; the largest loop was kept."
    const QString undo = HintText::tr("<kbd>%1</kbd> undoes it.").arg(undoKeys.toHtmlEscaped());
    return QStringLiteral("%1 %2").arg(sentence, undo);
}

} // namespace fff::ui
