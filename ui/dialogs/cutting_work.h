// What would be cut of the session's model as it lies on its sheets, and the paths of that: worked
// out anew whenever the model or the choices change, beside the window. Nobody waits for it.
#pragma once

#include <QObject> // first: moc stumbles over some standard headers

#include "core/analysis/nested.h"
#include "core/base/result.h"
#include "core/session/sheet_nesting.h"
#include "ui/dialogs/sheet_paths.h"

#include <QPointer>

#include <memory>
#include <optional>
#include <vector>

namespace fff {
class Session;
} // namespace fff

namespace fff::ui {

class CuttingWork : public QObject
{
    Q_OBJECT
public:
    /// The session outlives what is asked of it; a window's nesting may go before.
    CuttingWork(const Session &session, SheetNesting &nesting, QObject *parent = nullptr);
    ~CuttingWork() override;

    /// Nothing is worked out for it while it is not wanted, as at first.
    void setWanted(bool isWanted);

    /// How cuts are made; none but what is closed until somebody says. And whether the numbers of
    /// joints are in a colour for each.
    void setLook(const CutFinish &finish, bool hasJointColours = false);

    struct Made
    {
        AnalysisPointer analysis; // that it was made of
        std::shared_ptr<const Nested> nested;
        CutFinish finish;
        bool hasJointColours = false;
        std::vector<SheetPaths> sheets; // of its drawing, with that
    };
    /// The newest that is known; null at first. Stays while something newer is worked out.
    const std::shared_ptr<const Made> &made() const { return m_made; }
    /// What can be cut by that; null: nothing, whyNot() says why.
    const Cutting *cutting() const;
    std::optional<Error> whyNot() const;
    /// made() is not of the model and the choices that are there.
    bool isWorking() const;

Q_SIGNALS:
    void changed();

private:
    struct Mail;

    bool isAsked(const Made &made) const; // as it is to look
    void begin();
    void take(std::shared_ptr<const Made> made);

    const Session &m_session;
    QPointer<SheetNesting> m_nesting;
    std::shared_ptr<Mail> m_mail; // to here, as long as this lives
    std::shared_ptr<const Made> m_made;
    CutFinish m_finish;
    bool m_hasJointColours = false;
    bool m_isRunning = false;
};

} // namespace fff::ui
