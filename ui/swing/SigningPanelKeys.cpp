#include "ui/swing/SigningPanel.h"

#include <QComboBox>
#include <QDir>
#include <QFileInfo>
#include <QLineEdit>
#include <QPushButton>

#include "db/openpgp/KeyCheck.h"
#include "ui/kit/Words.h"

namespace lubberline::ui {

void SigningPanel::showEvent(QShowEvent* event)
{
    QFrame::showEvent(event);
    listKeys();
}

/// Once, and only where there is a key ring: gpg would make one.
void SigningPanel::listKeys()
{
    const QString home = qEnvironmentVariable("GNUPGHOME", QDir::homePath() + QStringLiteral("/.gnupg"));
    if (m_listed || !isVisible() || m_signRow->isHidden() || !QFileInfo(home).isDir())
        return;
    m_listed = true;
    m_listing.start([](const Progress& progress) { return db::secretKeys(progress); });
}

void SigningPanel::showKeys(const Result<std::vector<db::OpenPgpKey>>& keys)
{
    if (!keys) {
        m_key->setToolTip(messageOf(keys.error()));
        return;
    }
    for (const db::OpenPgpKey& one : *keys)
        m_key->addItem(tr("%1 (key …%2)").arg(toText(one.userId), toText(one.fingerprint).right(8)), toText(one.fingerprint));
}

/// The swing is prepared here, its text signed on a worker: somebody may have to look for his card.
void SigningPanel::signWithKey(Signature signature)
{
    auto& signing = m_context.stores.signing;
    const SwingId id = record().swing.id;
    if (const auto seen = asSeen([]() -> Result<void> { return {}; }); !seen) {
        emit failed(messageOf(seen.error()));
        return;
    }
    const auto prepared = signing.prepare(id, std::move(signature));
    const auto content = prepared ? signing.contentOf(id, *prepared) : Result<std::string>(prepared.error());
    if (!content) {
        emit failed(messageOf(content.error()));
        return;
    }
    m_signing = id;
    m_sign->setEnabled(false);
    m_cancel->show();
    m_byKey.start(
        [prepared = *prepared, content = *content](const Progress& progress) { return db::signedBy(prepared, content, progress); });
}

void SigningPanel::finishSigning(const Result<Signature>& made)
{
    m_sign->setEnabled(true);
    m_cancel->hide();
    // What was prepared for one swing is added to that one, whatever is shown by now.
    if (done(made ? m_context.stores.signing.add(m_signing, *made) : Result<void>(made.error()))) {
        m_name->clear();
        m_licence->clear();
    }
}

} // namespace lubberline::ui
