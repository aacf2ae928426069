// SPDX-License-Identifier: BSD-3-Clause
// Tests that a store holds every texel of the light field that it was packed from, for ours and for
// another reader.
#define XXH_INLINE_ALL
#include <OpenImageIO/imageio.h>
#include <xxhash.h>

#include <QTemporaryDir>
#include <QTest>
#include <cstring>
#include <map>

#include "io/documents/session_file.h"
#include "io/opening/session_around.h"
#include "io/scene/view_source.h"
#include "io/store/light_field_store.h"
#include "io/store/store_writer.h"
#include "tests/io/any_images.h"
#include "tests/io/documents.h"
#include "tests/io/light_fields.h"

using namespace hogelscope;

namespace {

constexpr std::size_t plenty = std::size_t{1} << 30;

/// Packs it as store.tif and returns the light field that it was.
LightField packed(const LightFieldParams& params, const PanelParams& display,
                  std::size_t memory = plenty) {
  const auto file = openLightField(params, display);
  const PackPlan plan = planPack(params, *file, display, memory);
  pack(*file, plan, "store.tif", 3, {});
  return openLightField(params, display)->read({});
}

}  // namespace

class TestStore : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init();
  void everyTexel_data();
  void everyTexel();
  void views();
  void quilt();
  void incoming();
  void blackTilesTakeNoRoom();
  void blocksOfAnyOrderAndCache();
  void littleMemoryMakesLowerBlocks();
  void anotherReader_data();
  void anotherReader();
  void overview();
  void slices_data();
  void slices();
  void sliceBeyondTheMemoryAllowed();
  void sizeIsForetold();
  void displayIsKept();
  void pageNames();
  void contentHash();
  void recognised();

 private:
  std::unique_ptr<QTemporaryDir> m_folder;
};

void TestStore::init() {
  m_folder = std::make_unique<QTemporaryDir>();
  QVERIFY(QDir::setCurrent(m_folder->path()));
}

void TestStore::everyTexel_data() {
  QTest::addColumn<QList<int>>("cells");
  QTest::addColumn<int>("type");
  const QList<int> even{16, 16, 16, 8};
  const QList<int> odd{19, 11, 13, 9};
  QTest::newRow("8 bit") << even << int(PictureType::UInt8);
  QTest::newRow("8 bit, odd") << odd << int(PictureType::UInt8);
  QTest::newRow("16 bit") << even << int(PictureType::UInt16);
  QTest::newRow("16 bit, odd") << odd << int(PictureType::UInt16);
  QTest::newRow("float, odd") << odd << int(PictureType::Float);
  QTest::newRow("float") << even << int(PictureType::Float);
  QTest::newRow("one hogel") << QList<int>{1, 1, 70, 65} << int(PictureType::UInt8);
  QTest::newRow("one direction") << QList<int>{70, 65, 1, 1} << int(PictureType::UInt8);
  QTest::newRow("one row") << QList<int>{33, 1, 17, 1} << int(PictureType::UInt8);
  QTest::newRow("few directions") << QList<int>{20, 21, 3, 5} << int(PictureType::UInt8);
}

void TestStore::everyTexel() {
  QFETCH(QList<int>, cells);
  QFETCH(int, type);
  const LightFieldSize size{cells[0], cells[1], cells[2], cells[3]};
  writeImageFile("a.tif", int(size.width()), int(size.height()), hogelImage(size),
                 {PictureType(type)});
  const LightField source = packed(paramsOf("a.tif"), displayOf(size));
  LightFieldStore store("store.tif");
  QVERIFY(store.size() == size);
  QCOMPARE(firstDifference(store.read({}), source), QString());
  QCOMPARE(firstDifference(streamed(store), source), QString());
  QCOMPARE(namesIn("."), (QStringList{"a.tif", "store.tif"}));
}

void TestStore::views() {
  constexpr LightFieldSize size{21, 18, 5, 3};
  for (int v = 0; v < size.dv; ++v)
    for (int u = 0; u < size.du; ++u)
      writeImageFile(QString("views/%1_%2.png").arg(v, 3, 10, QChar('0')).arg(u, 3, 10, QChar('0')),
                     size.nx, size.ny, [&](int x, int y, int c) {
                       return valueAt({x, y, u, v}, c);
                     });
  const LightField source = packed(paramsOf("views", Layout::views), {});
  QVERIFY(source.size() == size);
  QCOMPARE(firstDifference(LightFieldStore("store.tif").read({}), source), QString());
}

void TestStore::quilt() {
  writeImageFile("a_qs3x2a1.png", 60, 40, [](int x, int y, int c) {
    return valueAt({x % 20, y % 20, x / 20, y / 20}, c);
  });
  const LightField source = packed(paramsOf("a_qs3x2a1.png", Layout::quilt), {});
  QVERIFY((source.size() == LightFieldSize{20, 20, 6, 1}));
  QCOMPARE(firstDifference(LightFieldStore("store.tif").read({}), source), QString());
}

/// Turned while it is packed, or while the store is read.
void TestStore::incoming() {
  constexpr LightFieldSize size{10, 9, 11, 7};
  writeImageFile("a.png", int(size.width()), int(size.height()), hogelImage(size));
  const LightField turned = packed(paramsOf("a.png", Layout::hogels, true), displayOf(size));
  QCOMPARE(firstDifference(LightFieldStore("store.tif").read({}), turned), QString());
  const LightField plain = packed(paramsOf("a.png"), displayOf(size));
  QVERIFY(!firstDifference(plain, turned).isEmpty());
  LightFieldStore store("store.tif", true);
  QCOMPARE(firstDifference(store.read({}), turned), QString());
  QCOMPARE(firstDifference(streamed(store), turned), QString());
}

void TestStore::blackTilesTakeNoRoom() {
  constexpr LightFieldSize size{64, 16, 32, 16};
  const auto black = [](int, int, int) { return 0.0F; };
  writeImageFile("a.png", int(size.width()), int(size.height()), black);
  const LightField source = packed(paramsOf("a.png"), displayOf(size));
  // 2 pages of 64 tiles: an entry of the index has 12 bytes, nothing else grows with their number.
  QVERIFY(QFileInfo("store.tif").size() < 5 * 64 * 12);
  QCOMPARE(firstDifference(LightFieldStore("store.tif").read({}), source), QString());
}

void TestStore::blocksOfAnyOrderAndCache() {
  constexpr LightFieldSize size{19, 17, 20, 9};
  writeImageFile("a.png", int(size.width()), int(size.height()), hogelImage(size));
  const LightField source = packed(paramsOf("a.png"), displayOf(size));
  constexpr std::size_t blockBytes = 64 * 64 * 3;
  for (const std::size_t cache : {std::size_t{0}, 16 * 2 * blockBytes, plenty}) {
    const LightFieldStore store("store.tif", false, cache, 3);
    const BlockIndex block = store.header().block;
    std::vector<BlockIndex> wanted;
    for (int k = 0; k < 400; ++k)  // twice or more
      wanted.push_back({k * 7 % 3, k * 5 % 3, k * 11 % 3, k % 2});
    std::vector<int> wrong(wanted.size(), -1);
    store.blocks(wanted,
                 [&](std::size_t k, std::span<const std::byte> texels) {
                   const auto [I, J, U, V] = wanted[k];
                   wrong[k] = 0;
                   for (int y = 0; y < 64; ++y)
                     for (int x = 0; x < 64; ++x) {
                       const TexelIndex at{I * block.i + x / block.u, J * block.j + y / block.v,
                                           U * block.u + x % block.u, V * block.v + y % block.v};
                       const bool isIn =
                           at.i < size.nx && at.j < size.ny && at.u < size.du && at.v < size.dv;
                       const Rgb should = isIn ? source.texel(at) : Rgb{};
                       const auto value = [&, x = x, y = y](int c) {
                         return double(texels[std::size_t(3 * (64 * y + x) + c)]);
                       };
                       if (value(0) != should.r || value(1) != should.g || value(2) != should.b)
                         ++wrong[k];
                     }
                 },
                 {});
    QCOMPARE(wrong, std::vector<int>(wanted.size(), 0));
  }
}

void TestStore::littleMemoryMakesLowerBlocks() {
  constexpr LightFieldSize size{20, 32, 16, 16};
  writeImageFile("a.png", int(size.width()), int(size.height()), hogelImage(size));
  constexpr std::size_t hogelRow = 3 * 20 * 16 * 16;
  for (const auto& [rows, expected] :
       std::vector<std::pair<std::size_t, int>>{{20, 8}, {9, 8}, {8, 4}, {5, 4}, {2, 1}, {1, 1}}) {
    const LightField source = packed(paramsOf("a.png"), displayOf(size), rows * hogelRow);
    LightFieldStore store("store.tif");
    QCOMPARE(store.header().block.j, expected);
    QCOMPARE(store.header().block.v, 64 / expected);
    QCOMPARE(firstDifference(store.read({}), source), QString());
  }
  QVERIFY_EXCEPTION_THROWN((void)packed(paramsOf("a.png"), displayOf(size), hogelRow - 1),
                           InputError);
}

void TestStore::anotherReader_data() {
  QTest::addColumn<int>("type");
  QTest::newRow("8 bit") << int(PictureType::UInt8);
  QTest::newRow("16 bit") << int(PictureType::UInt16);
  QTest::newRow("float") << int(PictureType::Float);
}

/// OpenImageIO finds each texel where store_header.h says that it is.
void TestStore::anotherReader() {
  QFETCH(int, type);
  constexpr LightFieldSize size{19, 17, 20, 9};
  writeImageFile("a.tif", int(size.width()), int(size.height()), hogelImage(size),
                 {PictureType(type)});
  const LightField source = packed(paramsOf("a.tif"), displayOf(size));
  const StoreHeader header = LightFieldStore("store.tif").header();
  const auto& block = header.block;
  const auto in = OIIO::ImageInput::open("store.tif");
  QVERIFY(in);
  QCOMPARE(int(specOf("store.tif").type), type);
  for (int page = 0; page < header.blocks().j; ++page) {
    std::vector<float> values(std::size_t(in->spec_dimensions(page).image_pixels()) * 3);
    QVERIFY2(in->read_image(page, 0, 0, 3, OIIO::TypeDesc::FLOAT, values.data()),
             in->geterror().c_str());
    const int width = in->spec_dimensions(page).width;
    for (int j = page * block.j; j < std::min(size.ny, (page + 1) * block.j); ++j)
      for (int i = 0; i < size.nx; ++i)
        for (int v = 0; v < size.dv; ++v)
          for (int u = 0; u < size.du; ++u) {
            const int column = i / block.i * header.blocks().u + u / block.u;
            const int x = 64 * column + i % block.i * block.u + u % block.u;
            const int y = 64 * (v / block.v) + j % block.j * block.v + v % block.v;
            const float* rgb = &values[std::size_t(3) * std::size_t(y * width + x)];
            const Rgb is{rgb[0] * 255.0, rgb[1] * 255.0, rgb[2] * 255.0};
            QVERIFY2(isNear(is, source.texel({i, j, u, v}), 1e-4),
                     qPrintable(QString("%1 %2 %3 %4").arg(i).arg(j).arg(u).arg(v)));
          }
  }
}

void TestStore::overview() {
  constexpr LightFieldSize size{40, 30, 45, 33};
  writeImageFile("a.png", int(size.width()), int(size.height()), hogelImage(size));
  const LightField source = packed(paramsOf("a.png"), displayOf(size));
  const auto shared = LightFieldStore("store.tif").overview();
  const LightField& small = *shared;
  const LightFieldSize& shown = small.size();
  QCOMPARE(shown.du, 32);
  QCOMPARE(shown.dv, 32);
  const double share =
      double(shown.width() * shown.height()) / double(size.width() * size.height());
  QVERIFY2(share > 0.1 && share <= 0.125, qPrintable(QString::number(share)));
  const auto middle = [](int k, int cells, int all) { return int((k + 0.5) * all / cells); };
  QCOMPARE(firstWrong(small,
                      [&](const TexelIndex& at) {
                        return source.texel(
                            {middle(at.i, shown.nx, size.nx), middle(at.j, shown.ny, size.ny),
                             middle(at.u, shown.du, size.du), middle(at.v, shown.dv, size.dv)});
                      }),
           QString());
  const LightFieldSize paper = overviewSize({512, 512, 600, 600}, StoredType::uint8);
  QVERIFY(paper.width() * paper.height() * 4 <= 64000000);
  QVERIFY(paper.width() * paper.height() * 4 > 60000000);
}

void TestStore::slices_data() {
  QTest::addColumn<bool>("incoming");
  QTest::addColumn<int>("type");
  QTest::newRow("8 bit") << false << int(PictureType::UInt8);
  QTest::newRow("16 bit") << false << int(PictureType::UInt16);
  QTest::newRow("float, incoming") << true << int(PictureType::Float);
}

namespace {

Footprint allOf(const LightFieldSize& size) {
  Footprint all(size.nx, size.ny);
  for (CellRange& range : all.u) range = {0, size.du - 1};
  for (CellRange& range : all.v) range = {0, size.dv - 1};
  return all;
}

}  // namespace

void TestStore::slices() {
  QFETCH(bool, incoming);
  QFETCH(int, type);
  constexpr LightFieldSize size{19, 17, 20, 19};
  writeImageFile("a.tif", int(size.width()), int(size.height()), hogelImage(size),
                 {PictureType(type)});
  (void)packed(paramsOf("a.tif"), displayOf(size));
  const LightField source =
      openLightField(paramsOf("a.tif", Layout::hogels, incoming), displayOf(size))->read({});
  const auto store = std::make_shared<LightFieldStore>("store.tif", incoming, std::size_t{1} << 20);
  for (int width : {1, 3, 19}) {
    Footprint wanted;
    for (int i = 0; i < size.nx; ++i)
      wanted.u.push_back(i % 5 == 4 ? CellRange{}
                                    : CellRange{i % (21 - width), i % (21 - width) + width - 1});
    for (int j = 0; j < size.ny; ++j)
      wanted.v.push_back(j % 7 == 6 ? CellRange{}
                                    : CellRange{j % (20 - width), j % (20 - width) + width - 1});
    const auto slice = store->slice({[&] { return wanted; }, {}}, {});
    QVERIFY(slice->covers(wanted) && !slice->isInMemory());
    Footprint more = wanted;
    more.u[0].include({0, size.du - 1});
    QVERIFY(!slice->covers(more));
    std::size_t seen = 0;
    for (int j = 0; j < size.ny; ++j)
      for (int i = 0; i < size.nx; ++i)
        for (int v = wanted.v[std::size_t(j)].first; v <= wanted.v[std::size_t(j)].last; ++v)
          for (int u = wanted.u[std::size_t(i)].first; u <= wanted.u[std::size_t(i)].last; ++u) {
            QVERIFY2(slice->texel({i, j, u, v}) == source.texel({i, j, u, v}),
                     qPrintable(QString("%1 %2 %3 %4").arg(i).arg(j).arg(u).arg(v)));
            ++seen;
          }
    QCOMPARE(seen, wanted.texels());
  }
  QVERIFY(store->texel({18, 16, 7, 3}) == source.texel({18, 16, 7, 3}));
  QVERIFY_EXCEPTION_THROWN(
      (void)store->slice({[&] { return allOf(size); }, {}}, [](double) { return false; }),
      Cancelled);
}

void TestStore::sliceBeyondTheMemoryAllowed() {
  constexpr LightFieldSize size{10, 9, 11, 7};
  writeImageFile("a.png", int(size.width()), int(size.height()), hogelImage(size));
  (void)packed(paramsOf("a.png"), displayOf(size));
  LightFieldStore store("store.tif");
  const std::function<Footprint()> all = [&] { return allOf(size); };
  allowMemory(1000);
  const QString error = errorOf([&] { (void)store.slice({all, {}}, {}); });
  allowMemory(0);
  QCOMPARE(
      error,
      QString("memory: a view needs 27.7 kB of the light field, 1 kB are allowed: allow more"));
  QCOMPARE((store.slice({all, {}}, {})->size() == size), true);
}

/// What JPEG has lost makes a store no smaller.
void TestStore::sizeIsForetold() {
  constexpr LightFieldSize size{10, 9, 11, 7};
  const auto foretold = [&](const char* file) {
    writeImageFile(file, int(size.width()), int(size.height()), hogelImage(size));
    const auto opened = openLightField(paramsOf(file), displayOf(size));
    return planPack(paramsOf(file), *opened, {}, plenty).storeBytes;
  };
  const std::uint64_t ofPng = foretold("a.png");
  QCOMPARE(ofPng, std::uint64_t(QFileInfo("a.png").size()));
  const auto ofPixels = std::uint64_t(0.8 * 3 * 10 * 9 * 11 * 7);
  QCOMPARE(foretold("a.jpg"), ofPixels);
  QCOMPARE(foretold("b.JPG"), ofPixels);
}

void TestStore::displayIsKept() {
  constexpr LightFieldSize size{10, 9, 11, 7};
  writeImageFile("a.png", int(size.width()), int(size.height()), hogelImage(size));
  PanelParams display = displayOf(size);
  display.fov = {47, 31};
  display.size = {0.3, 0.2};
  display.position = {1, 2, 3};
  display.lens = HogelLensModel::equiangular;
  LightFieldParams converging = paramsOf("a.png");
  converging.viewingDistance = 0.75;
  (void)packed(converging, display);
  const Session around = sessionAround("store.tif");
  QVERIFY(around.display == display);
  QCOMPARE(around.lightField.viewingDistance, 0.75);
  display.viewingDistance = 0.75;
  QVERIFY(LightFieldStore("store.tif").header().display == display);
  PanelParams other;
  other.hogels = {10, 8};
  QVERIFY_EXCEPTION_THROWN((void)openLightField(paramsOf("store.tif", Layout::pack), other),
                           InputError);
}

/// As the format says; the offsets and sizes by our reader, the bytes and the hash by nobody of
/// ours.
void TestStore::pageNames() {
  constexpr LightFieldSize size{40, 30, 20, 19};
  const auto image = hogelImage(size);
  writeImageFile("a.png", int(size.width()), int(size.height()),
                 [&](int x, int y, int c) { return y < 200 ? 0 : image(x, y, c); });
  (void)packed(paramsOf("a.png"), displayOf(size));
  const QByteArray bytes = contentOf("store.tif");
  const RandomAccessFile file("store.tif");
  int pages = 0, black = 0;
  for (TiffLink link = firstLink(file); link.next != 0; ++pages) {
    const DecodedPage page = readPage(file, link.next);
    const auto numbers = [&]<class T>(std::uint64_t at, T) {
      std::vector<T> list(page.page.tiles());
      std::memcpy(list.data(), bytes.data() + at, list.size() * sizeof(T));
      return list;
    };
    const auto offsets = numbers(page.page.offsetsAt, std::uint64_t{});
    auto sizes = numbers(page.page.countsAt, std::uint32_t{});
    std::map<std::uint64_t, int> uses;
    for (const std::uint64_t offset : offsets) ++uses[offset];
    QByteArray tiles;
    for (std::size_t k = 0; k < sizes.size(); ++k) {
      const bool isBlack = uses[offsets[k]] > 1;
      if (isBlack) sizes[k] = 0, ++black;
      tiles += bytes.mid(qsizetype(offsets[k]), sizes[k]);
    }
    tiles.append(reinterpret_cast<const char*>(sizes.data()), qsizetype(4 * sizes.size()));
    const XXH128_hash_t hash = XXH3_128bits(tiles.data(), std::size_t(tiles.size()));
    QCOMPARE(QString::fromStdString(page.texts.name), QString("XXH3-128 %1%2")
                                                          .arg(hash.high64, 16, 16, QChar('0'))
                                                          .arg(hash.low64, 16, 16, QChar('0')));
    link = page.link;
  }
  QVERIFY(pages > 2 && black > 0);
}

/// The same wherever the texels come from, and another for other texels.
void TestStore::contentHash() {
  constexpr LightFieldSize size{19, 17, 20, 19};
  PictureValue image = hogelImage(size);
  const auto hashOf = [&](const char* name, const PanelParams& display) {
    writeImageFile(name, int(size.width()), int(size.height()), image);
    (void)packed(paramsOf(name), display);
    return LightFieldStore("store.tif").contentHash();
  };
  PanelParams display = displayOf(size);
  const std::string hash = hashOf("a.png", display);
  QCOMPARE(hash.size(), std::size_t(32));
  display.size[0] *= 2;
  QCOMPARE(hashOf("b.png", display), hash);
  image = [was = image](int x, int y, int c) {
    return was(x, y, c) + (x == 5 && y == 7 ? 0.1F : 0);
  };
  QVERIFY(hashOf("a.png", display) != hash);
  QByteArray bytes = contentOf("store.tif");
  const qsizetype last = bytes.lastIndexOf("XXH3-128 ");
  bytes[last] = '-';
  writeFile("store.tif", bytes);
  QCOMPARE(LightFieldStore("store.tif").contentHash(), std::string());
}

void TestStore::recognised() {
  constexpr LightFieldSize size{10, 9, 11, 7};
  writeImageFile("a.tif", int(size.width()), int(size.height()), hogelImage(size), PictureKind{});
  (void)packed(paramsOf("a.tif"), displayOf(size));
  QFile::rename("store.tif", "of any name");
  QVERIFY(lightFieldOf("of any name").layout == Layout::pack);
  QVERIFY(lightFieldOf("a.tif").layout == Layout::hogels);
  QVERIFY(withFile(paramsOf("a.tif"), "of any name").layout == Layout::pack);
  QVERIFY(withFile(paramsOf("of any name", Layout::pack), "a.tif").layout == Layout::hogels);
  QCOMPARE(errorOf([&] { (void)openLightField(paramsOf("of any name"), displayOf(size)); }),
           QString("of any name: lightField.layout: is \"hogels\", but the file is a store: give "
                   "\"pack\""));
}

QTEST_APPLESS_MAIN(TestStore)
#include "test_store.moc"
