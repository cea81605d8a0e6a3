#include "datasets/session/DepthReading.h"

#include <gtest/gtest.h>

namespace umbra {
namespace {

TEST(DepthReading, ADepthFileIsReadAtItsTexelsInDouble) {
  Session session;
  session.frame.read.filter = ReadFilter::Anisotropic;
  EXPECT_EQ(readSettingsOf(session), session.frame) << "a scene is read as is set";
  session.source.kind = SourceKind::DepthFile;
  EXPECT_EQ(readSettingsOf(session).read.filter, ReadFilter::Point);
  EXPECT_EQ(session.frame.map.format, StorageFormat::Float);
  chooseFormatFor(session);
  EXPECT_EQ(session.frame.map.format, StorageFormat::Double);
  session.source.kind = SourceKind::MeshFile;
  chooseFormatFor(session);
  EXPECT_EQ(session.frame.map.format, StorageFormat::Float) << "textures hold no double";
}

TEST(DepthReading, AFormatThatWasChosenStays) {
  Session session;
  for (const SourceKind kind : {SourceKind::DepthFile, SourceKind::Catalogue})
    for (const StorageFormat format :
         {StorageFormat::Half, StorageFormat::Unorm8, StorageFormat::Unorm16}) {
      session.source.kind = kind;
      session.frame.map.format = format;
      chooseFormatFor(session);
      EXPECT_EQ(session.frame.map.format, format);
    }
}

}  // namespace
}  // namespace umbra
