#include "ui/kit/FormField.h"

namespace lubberline::ui {

void markRefused(QLineEdit& edit, const QString& message)
{
    edit.setToolTip(message);
    edit.setStyleSheet(message.isEmpty() ? QString() : QStringLiteral("border: 2px solid #C62828"));
}

QString plainTitle(QString title) { return title.remove('&').remove(':').toLower(); }

} // namespace lubberline::ui
