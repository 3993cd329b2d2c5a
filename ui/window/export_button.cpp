#include "ui/window/export_button.h"

#include "ui/base/icon.h"
#include "ui/base/theme.h"

#include <QAction>
#include <QIcon>

namespace fff::ui {

ExportButton::ExportButton(QAction *exporting, QWidget *parent)
    : QPushButton(exporting->iconText(), parent)
{
    setIconSize({18, 18});
    setFocusPolicy(Qt::TabFocus); // as all of the bar: after a click keys are for the view
    const auto follow = [this, exporting] {
        setEnabled(exporting->isEnabled());
        setToolTip(exporting->toolTip());
    };
    follow();
    connect(exporting, &QAction::changed, this, follow);
    connect(this, &QPushButton::clicked, exporting, &QAction::trigger);
}

void ExportButton::refresh()
{
    const auto mask = [this](const QColor &colour) {
        return tintedPixmap(QStringLiteral("export"), 18, colour, devicePixelRatioF());
    };
    QIcon exporting(mask(theme().onAccent));
    exporting.addPixmap(mask(theme().muted), QIcon::Disabled);
    setIcon(exporting);
}

} // namespace fff::ui
