// What the kernel's readers refuse, and numbers read exactly.
#include "certify/kernel/files.h"

#include <gtest/gtest.h>

#include "certify/kernel/kernel.h"

namespace voroproof_kernel {
namespace {

template <class Read>
bool refused(Read&& read) {
  try {
    read();
  } catch (const Stop& stop) {
    return stop.verdict == Verdict::invalid;
  }
  return false;
}

TEST(KernelFiles, ExactStrings) {
  EXPECT_EQ(exact_string("0.1"), Rat(1, 10));
  EXPECT_EQ(exact_string("-1.5e3"), -1500);
  EXPECT_EQ(exact_string("1/3"), Rat(1, 3));
  EXPECT_EQ(exact_string("0x1.8p-3"), Rat(3, 16));
  for (const char* bad : {"", "-", ".5", "1.", "1e", "1e+", "1/0", "1/-3", "0x", "0x1p", "1e999",
                          "nan", "inf", "1 ", "0x1p9999", "--1", "1/2/3", "1.5/2"}) {
    EXPECT_TRUE(refused([&] { exact_string(bad); })) << bad;
  }
  EXPECT_TRUE(refused([] { exact_string(std::string(5000, '1')); }));
}

TEST(KernelFiles, Binary64) {
  for (const double x : {0.1, 1e-300, 5e-324, 1.7976931348623157e308, -3.0, 0x1p-1074, 0.3}) {
    EXPECT_EQ(nearest_binary64(exactly(x)), exactly(x));
  }
  // One tenth lies between two neighbours; 0.1 is the nearest.
  EXPECT_EQ(nearest_binary64(Rat(1, 10)), exactly(0.1));
  EXPECT_EQ(nearest_binary64(Rat(-1, 3)), exactly(-1.0 / 3.0));
  const Rat ulp = power(2, -52);
  EXPECT_EQ(nearest_binary64(1 + ulp / 2), 1);  // ties to even
  EXPECT_EQ(nearest_binary64(1 + ulp * 3 / 2), 1 + 2 * ulp);
  EXPECT_EQ(nearest_binary64(power(2, -1076)), 0);
  EXPECT_TRUE(refused([] { nearest_binary64(power(2, 1024)); }));
}

TEST(KernelFiles, LengthsAreBoundedFromAbove) {
  for (const Vec& v :
       {Vec{3, 4}, Vec{Rat(1, 3), 0}, Vec{power(2, -300), power(2, -301)}, Vec{power(2, 200), 1}}) {
    const Rat bound = length_above(v);
    EXPECT_GE(square(bound), norm2(v));
    EXPECT_LE(square(Rat(bound * (1 - power(2, -50)))), norm2(v));
  }
}

TEST(KernelFiles, HashesAreThoseOfTheStandard) {
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sha256(std::string(1000000, 'a')),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

const std::string kScene = R"({"format": "voroproof-scene", "version": 1,
 "container": {"center": [0, 0], "radius": 10}, "horizon": 3,
 "disks": [{"center": [-2, 0], "radius": 1, "velocity": [1, 0]},
           {"center": [2, "1/3"], "radius": 1, "velocity": [0, 0]}]})";

std::string changed(const std::string& from, const std::string& to) {
  std::string text = kScene;
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(KernelFiles, Scenes) {
  const Scene scene = read_scene(kScene);
  EXPECT_EQ(scene.disks[1].center[1], Rat(1, 3));
  EXPECT_EQ(scene.disks[0].mass, 1);
  // The limits are the binary64 nearest to 1e-100 and 1e100, the latter beyond 10^100.
  const auto with_horizon = [](const std::string& horizon) {
    std::string text = kScene;
    return text.replace(text.find("\"horizon\": 3"), 12, "\"horizon\": " + horizon);
  };
  EXPECT_EQ(read_scene(with_horizon("1e100")).horizon, exactly(1e100));
  EXPECT_EQ(read_scene(with_horizon("1e-100")).horizon, exactly(1e-100));
  EXPECT_TRUE(refused([&] { read_scene(with_horizon("1.0000000000000002e100")); }));
  EXPECT_TRUE(refused([&] { read_scene(with_horizon("9.999999999999999e-101")); }));
  struct Change {
    const char *from, *to;
  };
  const Change bad[] = {
      {"\"version\": 1", "\"version\": 2"},
      {"\"version\": 1", "\"version\": 1, \"version\": 1"},
      {"\"version\": 1", "\"version\": 1, \"other\": 1"},
      {"\"horizon\": 3", "\"horizon\": -3"},
      {"\"horizon\": 3", "\"horizon\": 1e-400"},
      {"\"horizon\": 3", "\"horizon\": 1e999"},
      {"\"horizon\": 3", "\"horizon\": null"},
      {"\"radius\": 10", "\"radius\": 0"},
      {"[-2, 0]", "[-12, 0]"},
      {"[-2, 0]", "[0.5, 0]"},
      {"[-2, 0]", "[-2]"},
      {"\"radius\": 1, \"velocity\": [1, 0]", "\"radius\": 0, \"velocity\": [1, 0]"},
      {"\"radius\": 1, \"velocity\": [1, 0]", "\"radius\": -1, \"velocity\": [1, 0]"},
      {"\"radius\": 1, \"velocity\": [1, 0]", "\"radius\": 1, \"mass\": 0, \"velocity\": [1, 0]"},
      {"[-2, 0], \"radius\": 1, \"velocity\": [1, 0]",
       "[-9, 0], \"radius\": 1, \"velocity\": [0, 1]"},
      {"\"horizon\": 3", "\"restitution\": 2, \"horizon\": 3"},
      {"\"horizon\": 3", "\"container_law\": \"odd\", \"horizon\": 3"},
      {"\"horizon\": 3",
       "\"horizon\": 3, \"maneuvers\": [{\"t\": 1, \"disk\": 2, \"velocity\": [0, 0]}]"},
      {"}]}", "}]"},
  };
  for (const Change& c : bad) {
    EXPECT_TRUE(refused([&] { read_scene(changed(c.from, c.to)); })) << c.from << " -> " << c.to;
  }
  EXPECT_TRUE(refused([] { read_scene(std::string(100000, '[')); }));
  EXPECT_TRUE(refused([] { read_scene(""); }));
}

// A seed is for the record and no number to compute with: an integer of 1000 characters is one.
TEST(KernelFiles, SeedsBeyond64Bits) {
  const auto with = [](const std::string& field) {
    return changed("\"horizon\": 3", field + ", \"horizon\": 3");
  };
  for (const std::string& seed : {std::string("18446744073709551616"), "-" + std::string(999, '9'),
                                  std::string(1000, '7'), std::string("\"any text\"")}) {
    EXPECT_EQ(read_scene(with("\"seed\": " + seed)).horizon, 3) << seed;
  }
  for (const std::string& seed :
       {std::string(1001, '7'), std::string("1e3"), std::string("18446744073709551616.0"),
        std::string("null"), "[" + std::string(30, '9') + "]"}) {
    EXPECT_TRUE(refused([&] { read_scene(with("\"seed\": " + seed)); })) << seed;
  }
  // Elsewhere such an integer is the nearest binary64, if there is one.
  EXPECT_EQ(read_scene(changed("\"horizon\": 3", "\"horizon\": 18446744073709551617")).horizon,
            power(2, 64));
  EXPECT_TRUE(refused(
      [] { read_scene(changed("\"horizon\": 3", "\"horizon\": 1" + std::string(400, '0'))); }));
}

std::string history(const std::string& lines, const std::string& horizon = "3") {
  return R"({"format":"voroproof-history","version":1,"scene_sha256":")" + sha256(kScene) +
         R"(","horizon":)" + horizon + R"(,"producer":"hand"})" + "\n" + lines;
}
const std::string kEnd = R"({"end":{"t":3,"flips":0,"collisions":0,"maneuvers":0}})";

TEST(KernelFiles, Histories) {
  EXPECT_FALSE(read_history(history(kEnd), read_scene(kScene)).stopped);
  EXPECT_TRUE(
      read_history(history(R"({"stopped":{"t":1,"reason":"x"}})"), read_scene(kScene)).stopped);
  for (const char* bad : {
           "{\"t\":1,\"flip\":[0,1,-1,-1]}",
           "{\"t\":2,\"flip\":[0,1,-1,-1]}\n{\"t\":1,\"flip\":[0,1,-1,-1]}\n",
           "{\"t\":4,\"flip\":[0,1,-1,-1]}\n",
           "{\"t\":1,\"flip\":[0,2,-1,-1]}\n",
           "{\"t\":1,\"flip\":[0,0,-1,-1]}\n",
           "{\"t\":1,\"flip\":[0,1,-1,-1],\"v\":1}\n",
           "{\"t\":1,\"collide\":[1,0]}\n",
           "{\"t\":1,\"collide\":[-1,0],\"v\":[[0,0],[0,0]]}\n",
           "{\"t\":1,\"collide\":[0,1],\"v\":[null,[0,0]]}\n",
           "{\"t\":1,\"maneuver\":-1}\n",
           "{\"t\":1}\n",
           "{\"t\":1e-400,\"maneuver\":0}\n",
           "{\"t\":1,\"t\":1,\"maneuver\":0}\n",
           "[]\n",
           "\n",
       }) {
    EXPECT_TRUE(refused([&] { read_history(history(bad + kEnd), read_scene(kScene)); })) << bad;
  }
  EXPECT_TRUE(refused([] { read_history(history(""), read_scene(kScene)); }));
  EXPECT_TRUE(refused([] { read_history(history(kEnd + "\n\n"), read_scene(kScene)); }));
  EXPECT_TRUE(refused([] { read_history(history(kEnd, "2"), read_scene(kScene)); }));
}

TEST(KernelFiles, Extensions) {
  EXPECT_EQ(read_scene(changed("\"horizon\"", "\"x-a\":[1],\"horizon\"")).disks.size(), 2u);
  EXPECT_EQ(read_scene(changed("\"radius\": 1,", "\"x-a\":{\"b\":2},\"radius\":1,")).disks.size(),
            2u);
  for (const char* bad : {"\"y-a\":1,", "\"x-a\":1,\"x-a\":2,", "\"x-a\":{\"b\":1,\"b\":2},"}) {
    EXPECT_TRUE(
        refused([&] { read_scene(changed("\"horizon\"", bad + std::string("\"horizon\""))); }));
  }
  EXPECT_TRUE(refused([] { read_scene(changed("\"radius\": 10", "\"radius\":10,\"x-a\":1")); }));
  const std::string flip = "{\"x-b\":1,\"t\":1,\"flip\":[0,1,-1,-1],\"x-a\":null}\n";
  const std::string end = kEnd.substr(0, kEnd.size() - 1);
  EXPECT_EQ(read_history(history(flip + end + ",\"x-a\":0}"), read_scene(kScene)).claims.size(),
            1u);
  EXPECT_TRUE(refused([&] {
    read_history(history(end.substr(0, end.size() - 1) + ",\"x-a\":0}}"), read_scene(kScene));
  }));
}

TEST(KernelFiles, ANewerFileIsToldAsSuch) {
  try {
    read_scene("{\"format\":\"voroproof-scene\",\"walls\":[],\"version\":3}");
    FAIL();
  } catch (const Stop& stop) {
    EXPECT_EQ(stop.verdict, Verdict::invalid);
    EXPECT_EQ(stop.reason, "of version 3; this program reads versions 1 and 2");
  }
}

// A row of touching disks whose abscissas were computed in binary64.
TEST(KernelFiles, OverlapsAreToldWithTheirAmount) {
  try {
    read_scene(R"({"format":"voroproof-scene","version":1,"horizon":2,
      "container":{"center":[0,0],"radius":3},"disks":[
      {"center":[0.1143,0],"radius":0.028575,"velocity":[0,0]},
      {"center":[0.17145,0],"radius":0.028575,"velocity":[0,0]}]})");
    ADD_FAILURE();
  } catch (const Stop& stop) {
    EXPECT_EQ(stop.verdict, Verdict::invalid);
    EXPECT_EQ(stop.reason, "two disks overlap by 6.93889e-18");
  }
}

TEST(KernelFiles, VerdictsOnBadInput) {
  EXPECT_EQ(check("", "", {}).verdict, Verdict::invalid);
  EXPECT_EQ(check(kScene, history(kEnd) + "x", {}).verdict, Verdict::invalid);
  EXPECT_EQ(check(kScene + " ", history(kEnd), {}).verdict, Verdict::invalid);  // another hash
  Options options;
  options.tolerance = "4";
  EXPECT_EQ(check(kScene, history(kEnd), options).verdict, Verdict::invalid);
  options.tolerance = "-1";
  EXPECT_EQ(check(kScene, history(kEnd), options).verdict, Verdict::invalid);
}

}  // namespace
}  // namespace voroproof_kernel
