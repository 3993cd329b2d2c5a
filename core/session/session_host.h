// Connects Interaction, which knows no Qt, to a Session, and gives its steps their names.
#pragma once

#include "core/interaction/interaction.h"
#include "core/session/session.h"

#include <QObject>

namespace fff {

class SessionHost : public QObject, public InteractionHost
{
    Q_OBJECT
public:
    /// The session outlives the host.
    explicit SessionHost(Session &session, QObject *parent = nullptr);

    /// Tells the interaction of every change of the model from now on, until the host goes.
    void attach(Interaction &interaction);

    const Model &model() const override;
    std::shared_ptr<const PulledTemplates> pulled() const override;
    void preview(Document document) override;
    void cancelPreview() override;
    void commit(const Step &step, Document document) override;
    void chooseProblem(int number, int place) override;
    void chooseParameter(OperationId operation, const std::string &key) override;

Q_SIGNALS:
    void problemChosen(int number, int place);
    void parameterChosen(fff::OperationId operation, const QString &key);

private:
    Session &m_session;
};

} // namespace fff
