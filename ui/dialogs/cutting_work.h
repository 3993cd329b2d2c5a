// What would be cut of the session's model, worked out anew whenever the model or the choices
// change: on another thread, and only of what is newest. Nobody waits for it.
#pragma once

#include <QObject> // first: moc stumbles over some standard headers

#include "core/analysis/cutting.h"
#include "core/base/result.h"
#include "ui/dialogs/sheet_paths.h"

#include <memory>
#include <optional>
#include <vector>

namespace fff {
class Session;
}

namespace fff::ui {

class CuttingWork : public QObject
{
    Q_OBJECT
public:
    /// The session outlives it.
    explicit CuttingWork(const Session &session, QObject *parent = nullptr);
    ~CuttingWork() override;

    void setOptions(const CuttingOptions &options);

    struct Made
    {
        AnalysisPointer analysis; // that it was made of
        Result<Cutting> cutting;
        std::vector<SheetPaths> sheets; // of its drawing
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

    void begin();
    void take(std::shared_ptr<const Made> made, const CuttingOptions &options);

    const Session &m_session;
    std::shared_ptr<Mail> m_mail; // to here, as long as this lives
    CuttingOptions m_options, m_optionsOfMade;
    std::shared_ptr<const Made> m_made;
    bool m_isRunning = false;
};

} // namespace fff::ui
