#include "ui/kit/FormField.h"

#include <QAction>
#include <QStyle>

namespace lubberline::ui {

void markRefused(QLineEdit& edit, const QString& message)
{
    edit.setToolTip(message);
    edit.setAccessibleDescription(message);
    edit.setStyleSheet(message.isEmpty() ? QString() : QStringLiteral("border: 2px solid #C62828"));
    const QString name = QStringLiteral("refusedSign");
    auto* sign = edit.findChild<QAction*>(name);
    if (message.isEmpty()) {
        delete sign;
    } else if (!sign) { // a shape besides the colour
        sign = edit.addAction(edit.style()->standardIcon(QStyle::SP_MessageBoxWarning), QLineEdit::TrailingPosition);
        sign->setObjectName(name);
    }
}

QString plainTitle(QString title) { return title.remove('&').remove(':').toLower(); }

} // namespace lubberline::ui
