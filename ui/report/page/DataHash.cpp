#include "ui/report/page/DataHash.h"

#include <QCryptographicHash>

#include "core/format/exchange/Exchange.h"

namespace lubberline::ui {

QString dataHash(const SwingRecord& record) { return hashOfText(writeExchange(toFleet(record))); }

QString hashOfText(const std::string& text)
{
    return QString::fromLatin1(QCryptographicHash::hash(QByteArray::fromStdString(text), QCryptographicHash::Sha256).toHex());
}

} // namespace lubberline::ui
