// .bez.json as it should not be: every defect has its line and its phrase.
#include "bezcert/io/mesh/bez_json.hpp"
#include "reading.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <string>
#include <vector>

namespace bezcert::test {
namespace {

// A text with one '@' before what is wrong: the line that the error must name.
struct Marked {
  std::string text;
  std::size_t line = 0;
};

Marked marked(std::string text) {
  const std::size_t at = text.find('@');
  INFO(text);
  REQUIRE(at != std::string::npos);
  const auto lines =
      static_cast<std::size_t>(std::count(text.begin(), text.begin() + static_cast<long>(at), '\n'));
  text.erase(at, 1);
  return {std::move(text), lines + 1};
}

void require_bad(const std::string& text, const std::string& phrase) {
  const Marked one = marked(text);
  INFO(one.text);
  require_refused(one.text, phrase, one.line);
}

const std::string good = R"("kind": "triangle", "degree": 1, "points": [[0,0], [1,0], [0,1]])";

// A file with one element, over several lines; `more` are further members of the root.
std::string file_of(const std::string& element, const std::string& more = "") {
  return "{ \"bezcert\": 1,\n" + more + "  \"elements\": [\n    " + element + " ] }";
}

struct Case {
  std::string text;
  std::string phrase;
};

std::vector<Case> root_cases() {
  const std::string elements = "\"elements\": [ {" + good + "} ]";
  return {
      {"\n@{ " + elements + " }", "has no \"bezcert\""},
      {"{\n\"bezcert\": @2 , " + elements + " }", "\"bezcert\" must be 1"},
      {"{ \"bezcert\":\n@\"1\", " + elements + " }", "\"bezcert\" must be 1"},
      {"{ \"bezcert\": @null , " + elements + " }", "\"bezcert\" must be 1"},
      {"{ \"bezcert\": @1e0 , " + elements + " }", "\"bezcert\" must be 1"},
      {"\n\n@{ \"bezcert\": 1\n }", "has no \"elements\""},
      {"{ \"bezcert\": 1,\n \"elements\": @{} }", "\"elements\" must be an array, not an object"},
      {"{ \"bezcert\": 1,\n \"elements\":\n @[] }", "there are no elements"},
      {"{ \"bezcert\": 1,\n \"elements\": [\n @3 ] }", "an element must be an object, not a number"},
      {file_of("{" + good + "}", "\"colour\":\n@\"red\",\n"), "the key \"colour\" is not known"},
      {file_of("{" + good + "}", "\"Elements\": @[],\n"), "the key \"Elements\" is not known"},
      {"{ \"bezcert\": 1,\n @\"bezcert\": 1, " + elements + " }", "the key \"bezcert\" is repeated"},
      {file_of("{" + good + "}", "\"points\": [[0,0]],\n@\"points\": [],\n"),
       "the key \"points\" is repeated"},
      {file_of("{" + good + "}", "\"weights\":\n@[1],\n"), "go with \"points\" of the file"},
      {file_of("{" + good + "}", "\"points\": @3 ,\n"), "\"points\" must be an array"},
      {file_of("{" + good + "}", "\"points\": [[0,0]], \"weights\":\n@[1,2],\n"), "2 weights for 1 points"},
      {file_of("{" + good + "}", "\"points\": [[0,0],\n@[0]],\n"), "a point must be [x, y]"},
      {file_of("{" + good + "}", "\"points\": [[0,0],\n@\"0,0\"],\n"), "a point must be [x, y]"},
  };
}

std::vector<Case> element_cases() {
  const std::string shared = "\"points\": [[0,0], [1,0], [0,1]],\n";
  const auto triangle = [](const std::string& members) {
    return file_of("{ \"kind\": \"triangle\",\n" + members + " }");
  };
  const auto nodes = [&](const std::string& list) {
    return file_of("{ \"kind\": \"triangle\", \"degree\": 1,\n \"nodes\": " + list + " }", shared);
  };
  const std::string points = "\"points\": [[0,0], [1,0], [0,1]]";
  return {
      {file_of("{ " + good + ",\n \"color\":\n @3 }"), "the key \"color\" is not known"},
      {file_of("{ " + good + ",\n @\"degree\": 1 }"), "the key \"degree\" is repeated"},
      {file_of("@{ \"degree\": 1,\n " + points + " }"), "an element has no \"kind\""},
      {file_of("@{ \"kind\": \"triangle\",\n " + points + " }"), "an element has no \"degree\""},
      {file_of("{ \"kind\":\n @\"tetrahedron\", \"degree\": 1, " + points + " }"), "\"kind\" must be"},
      {file_of("{ \"kind\":\n @3 , \"degree\": 1, " + points + " }"), "\"kind\" must be"},
      {file_of("\n@{ \"kind\": \"triangle\",\n \"degree\": 1 }"), "either \"points\" or \"nodes\""},
      {file_of("@{ \"kind\": \"triangle\",\n \"degree\": 1, " + points + ", \"nodes\": [0,1,2] }", shared),
       "either \"points\" or \"nodes\""},
      {triangle("\"degree\": @0 , " + points), "a degree must be an integer from 1 to 64"},
      {triangle("\"degree\": @-1 , " + points), "a degree must be an integer from 1 to 64"},
      {triangle("\"degree\": @65 , " + points), "a degree must be an integer from 1 to 64"},
      {triangle("\"degree\": @1e9 , " + points), "a degree must be an integer from 1 to 64"},
      {triangle("\"degree\": @1000000000 , " + points), "a degree must be an integer from 1 to 64"},
      {triangle("\"degree\": @18446744073709551617 , " + points), "a degree must be an integer from 1 to 64"},
      {triangle("\"degree\": @1.5 , " + points), "a degree must be an integer from 1 to 64"},
      {triangle("\"degree\": @\"2\", " + points), "a degree must be an integer from 1 to 64"},
      {triangle("\"degree\": @null , " + points), "a degree must be an integer from 1 to 64"},
      {triangle("\"degree\": @[1,1], " + points), "a degree must be an integer from 1 to 64"},
      {file_of("{ \"kind\": \"quadrilateral\",\n \"degree\": @1 , " + points + " }"), "must be [p, q]"},
      {file_of("{ \"kind\": \"quadrilateral\",\n \"degree\": @[1], " + points + " }"), "must be [p, q]"},
      {file_of("{ \"kind\": \"quadrilateral\",\n \"degree\": @[1,1,1], " + points + " }"), "must be [p, q]"},
      {file_of("{ \"kind\": \"quadrilateral\",\n \"degree\": [1,\n@65 ], " + points + " }"), "from 1 to 64"},
      {file_of("{ \"kind\": \"quadrilateral\",\n \"degree\": [1,1],\n \"points\": @[[0,0],[1,0],[0,1]] }"),
       "has 4 points, not 3"},
      {triangle("\"degree\": 2,\n \"points\": @[[0,0],[1,0],[0,1]]"), "has 6 points, not 3"},
      {triangle("\"degree\": 1,\n \"points\": @[[0,0],[1,0],[0,1],[0,1]]"), "has 3 points, not 4"},
      {triangle("\"degree\": 1,\n \"points\": @[]"), "has 3 points, not 0"},
      {triangle("\"degree\": 1,\n \"points\": @{}"), "\"points\" must be an array, not an object"},
      {triangle("\"degree\": 1,\n \"points\": [[0,0],\n@[1,0,0], [0,1]]"), "a point must be [x, y]"},
      {triangle("\"degree\": 1,\n \"basis\": @\"bezier\", " + points), "\"basis\" must be"},
      {triangle("\"degree\": 1,\n \"basis\": @1 , " + points), "\"basis\" must be"},
      {triangle("\"degree\": 1,\n \"name\": @1 , " + points), "\"name\" must be a string, not a number"},
      {triangle("\"degree\": 1,\n \"expect\": @null , " + points), "\"expect\" must be a string, not null"},
      {triangle("\"degree\": 1,\n \"source\": @[], " + points), "\"source\" must be a string, not an array"},
      {triangle("\"degree\": 1, " + points + ",\n \"weights\": @[1,1]"), "2 weights for 3 points"},
      {triangle("\"degree\": 1, " + points + ",\n \"weights\": @1 "), "\"weights\" must be an array"},
      {triangle("\"degree\": 1, " + points + ", \"weights\": [1,\n@0 , 1]"), "the weight 0 is not positive"},
      {triangle("\"degree\": 1, " + points + ", \"weights\": [1,\n@\"-1/2\", 1]"),
       "the weight -1/2 is not positive"},
      {triangle("\"degree\": 1, " + points + ", \"weights\": [1,\n@true , 1]"), "a weight is"},
      {nodes("[0,1,\n@3 ]"), "a node must be an index"},
      {nodes("[0,\n@-1 ,2]"), "a node must be an index"},
      {nodes("[0,\n@0.5 ,2]"), "a node must be an index"},
      {nodes("[0,\n@\"1\",2]"), "a node must be an index"},
      {nodes("[0,\n@null ,2]"), "a node must be an index"},
      {nodes("[0,\n@18446744073709551616 ,2]"), "a node must be an index"},
      {nodes("[0,\n@4294967296 ,2]"), "a node must be an index"},
      {nodes("@[0,1]"), "has 3 points, not 2"},
      {nodes("@\"0 1 2\""), "\"nodes\" must be an array"},
      {file_of("{ \"kind\": \"triangle\", \"degree\": 1,\n \"nodes\": [@0 ,1,2] }"),
       "a node must be an index"},
      {file_of("{ \"kind\": \"triangle\", \"degree\": 1, \"nodes\": [0,1,2],\n \"weights\": @[1,1,1] }",
               shared),
       "takes the weights of the file"},
      // Lagrange weights (4, 1, 4) on an edge: the control point's is 2 * 1 - (4 + 4) / 2 = -2.
      {file_of("@{ \"kind\": \"triangle\", \"degree\": 2, \"basis\": \"lagrange\",\n \"points\": "
               "[[0,0],[1,0],[2,0],"
               "[0,1],[1,1],[0,2]],\n \"weights\": [4,1,4,4,4,4] }"),
       "not positive after conversion"},
      // (2, 1, 2): 2 * 1 - (2 + 2) / 2 = 0.
      {file_of("@{ \"kind\": \"triangle\", \"degree\": 2, \"basis\": \"lagrange\",\n \"points\": "
               "[[0,0],[1,0],[2,0],"
               "[0,1],[1,1],[0,2]],\n \"weights\": [2,1,2,2,2,2] }"),
       "not positive after conversion"},
  };
}

std::vector<Case> curve_cases() {
  const auto curve = [](const std::string& text) {
    return file_of("{" + good + "}", "\"curves\": " + text + ",\n");
  };
  return {
      {curve("@{}"), "\"curves\" must be an array"},
      {curve("[\n@1 ]"), "a curve must be an object"},
      {curve("[\n@{ \"points\": [[0,0],\n[1,0]] }]"), "a curve has no \"degree\""},
      {curve("[\n@{ \"degree\":\n1 }]"), "a curve has no \"points\""},
      {curve("[{ \"degree\": 1,\n \"kind\": @\"line\", \"points\": [[0,0],[1,0]] }]"),
       "the key \"kind\" is not known"},
      {curve("[{ \"degree\":\n@0 , \"points\": [[0,0]] }]"), "a degree must be"},
      {curve("[{ \"degree\": 2,\n \"points\":\n@[[0,0],[1,0]] }]"), "has 3 points, not 2"},
      {curve("[{ \"degree\": 1,\n \"points\": [[0,0],\n@[1]] }]"), "a point must be [x, y]"},
      {curve("[{ \"degree\": 1,\n \"points\": [[0,0],\n[1,@\"a\"]] }]"), "a coordinate is \"a\""},
      {curve("[{ \"degree\": 1, \"points\": [[0,0],[1,0]],\n \"weights\": @[1] }]"), "one weight a point"},
      {curve("[{ \"degree\": 1, \"points\": [[0,0],[1,0]],\n \"weights\": [1,\n@-1 ] }]"),
       "weight is not positive"},
      {curve("[{ \"degree\": 1, \"points\": [[0,0],[1,0]],\n@\"degree\": 1 }]"),
       "the key \"degree\" is repeated"},
  };
}

}  // namespace

TEST_CASE("bez.json defects of the file are refused with their line") {
  const auto cases = root_cases();
  for (const Case& one : cases) require_bad(one.text, one.phrase);
  CHECK(cases.size() == 18);
}

TEST_CASE("bez.json defects of elements are refused with their line") {
  const auto cases = element_cases();
  for (const Case& one : cases) require_bad(one.text, one.phrase);
  CHECK(cases.size() == 51);
}

TEST_CASE("bez.json defects of curves are refused with their line") {
  const auto cases = curve_cases();
  for (const Case& one : cases) require_bad(one.text, one.phrase);
  CHECK(cases.size() == 12);
}

// A number has no end of its own: the parser must look at what follows, here the end of the line.
TEST_CASE("bez.json lines are right where a number ends its line") {
  const std::string points = "\"points\": [[0,0],[1,0],[0,1]]";
  const std::vector<Case> cases = {
      {"{ \"bezcert\":@2\n , \"elements\": [] }", "must be 1"},
      {file_of("{ " + good + ",\n \"color\": @3\n }"), "the key \"color\" is not known"},
      {file_of("{ \"kind\": \"triangle\", \"degree\": @65\n , " + points + " }"), "a degree must be"},
      {file_of("{ \"kind\": \"triangle\", \"degree\": @1.5\n , " + points + " }"), "a degree must be"},
      {file_of("{ " + good + ", \"weights\": [\n1,\n@0\n,1] }"), "the weight 0 is not positive"},
      {file_of("{ " + good + ", \"weights\": [\n1,\n@-1.5\r\n,1] }"), "the weight -3/2 is not positive"},
      {file_of("{ \"kind\": \"triangle\", \"degree\": 1, \"nodes\": [0,0,\n@7\n\n\n] }",
               "\"points\": [[0,0]],\n"),
       "a node must be"},
  };
  for (const Case& one : cases) require_bad(one.text, one.phrase);
  CHECK(cases.size() == 7);
}

TEST_CASE("bez.json numbers that are none are refused, each where it stands") {
  const std::vector<std::string> strings = {"NaN",  "nan",   "inf",     "-Infinity", "1/0",      "0/0",
                                            "1/-2", "1.5/2", "1/2/3",   "/2",        "1/",       "",
                                            " 1",   "1 ",    "--1",     "1,5",       "0x10",     "1e",
                                            "e5",   ".",     "1e99999", "1e-99999",  "\xc2\xbd", "one"};
  std::size_t seen = 0;
  const auto element = [](const std::string& number) {
    return "{ \"kind\": \"triangle\", \"degree\": 1, \"points\": [[0,0],\n[1,@" + number + "],\n[0,1]] }";
  };
  for (const std::string& text : strings) {
    require_bad(file_of(element("\"" + text + "\"")),
                text.empty() ? std::string("y of a point is ") : "y of a point is \"" + text + "\"");
    ++seen;
  }
  for (const std::string json : {"null", "true", "[]", "{}"}) {
    require_bad(file_of(element(json)), "y of a point is ");
    ++seen;
  }
  for (const std::string json :
       {"NaN", "Infinity", "-", "01", "1.", ".5", "+1", "1e", "0x10", "1/2", "'1'"}) {
    require_bad(file_of(element(json)), "no JSON");
    ++seen;
  }
  CHECK(seen == 39);
  // One digit more than is read: 20,000 characters.
  require_bad(file_of(element("\"" + std::string(20001, '1') + "\"")), "y of a point is ");
}

TEST_CASE("bez.json that is no JSON is refused") {
  const std::string text = file_of("{" + good + "}");
  CHECK(!refusal(text));
  require_bad("{ \"bezcert\": 1,\n @}", "no JSON");
  require_bad("{ \"bezcert\": 1,\n @\"elements\" }", "no JSON");
  require_bad(text + "\n@x", "no JSON");
  require_bad(text + "\n\n@{}", "no JSON");
  require_bad("{ @// comment\n \"bezcert\": 1 }", "no JSON");
  // What does not start like one is no format that is known.
  for (const std::string& other :
       {std::string("[1]"), "\xef\xbb\xbf" + text, std::string("bezcert"), std::string("1")}) {
    require_refused(other, "the format is not known", 0);
  }
  for (const std::string& empty : {std::string(), std::string(" \n\r\n\t")})
    require_refused(empty, "the file is empty", 0);
  CHECK_THROWS_AS(read_bez_json("f", "[1]"), InputError);
}

TEST_CASE("bez.json nested too deep is refused, however deep") {
  std::size_t seen = 0;
  for (const std::size_t depth :
       {std::size_t{32}, std::size_t{1000}, std::size_t{100000}, std::size_t{3000000}}) {
    INFO("depth " << depth);
    require_refused("{\n\"bezcert\": " + std::string(depth, '['), "nested deeper than 32", 2);
    std::string objects = "{";
    for (std::size_t i = 0; i < depth; ++i) objects += "\"a\":{";
    require_refused(objects, "nested deeper than 32", 1);
    ++seen;
  }
  CHECK(seen == 4);
}

TEST_CASE("bez.json text that is no UTF-8 is refused") {
  const std::vector<std::string> bad = {"\xff",
                                        "\x80",
                                        "\xc0\xaf",
                                        "\xe2\x82",
                                        "\xed\xa0\x80",
                                        "\xf8\x88\x80\x80\x80",
                                        "\xf4\x90\x80\x80",
                                        "\\ud800",
                                        "\\udc00x",
                                        "\\ud800\\u0041"};
  for (const std::string& text : bad) {
    INFO("bytes of " << text);
    require_bad(file_of("{ " + good + ",\n \"name\": @\"" + text + "\" }"), "no JSON");
    require_bad(file_of("{ " + good + ",\n @\"" + text + "\": 1 }"), "no JSON");
  }
  CHECK(bad.size() == 10);
  CHECK(!refusal(file_of("{ " + good + ", \"name\": \"\xf0\x9f\x98\x80 \\ud83d\\ude00 \xc3\xa9\" }")));
}

TEST_CASE("bez.json messages are one printable line whatever the file holds") {
  const std::vector<std::string> keys = {"a\\nb", "a\\rb", "\\u001b[31mred", "\\u0000", "\\u007f", "\\u0007"};
  for (const std::string& key : keys) {
    require_bad(file_of("{ " + good + ",\n \"" + key + "\": @null }"), "is not known");
    require_bad(file_of("{ " + good + ",\n \"" + key + "\": 1,\n @\"" + key + "\": 2 }"), "is repeated");
    require_bad(file_of("{ \"kind\": \"triangle\", \"degree\": 1, \"points\": [[0,0],\n[@\"" + key +
                        "\",1],[0,1]] }"),
                "x of a point is");
  }
  CHECK(keys.size() == 6);
}

TEST_CASE("a small bez.json cut at any byte is refused") {
  const std::string text =
      file_of("{ " + good + ",\n \"weights\": [1, \"2/3\", 0.5], \"name\": \"\xc3\xa9\" }",
              "\"curves\": [{\"degree\": 1, \"points\": [[0,0],[1,0]]}],\n");
  REQUIRE(text.back() == '}');
  std::size_t refused = 0;
  for (std::size_t size = 0; size < text.size(); ++size) {
    const auto one = refusal(text.substr(0, size));
    INFO("the first " << size << " bytes");
    REQUIRE(one.has_value());
    CAPTURE(one->what);
    REQUIRE(is_one_line(one->what));
    // The line of the defect is no later than the last of the text.
    const auto lines =
        static_cast<std::size_t>(std::count(text.begin(), text.begin() + static_cast<long>(size), '\n'));
    REQUIRE(one->line <= lines + 1);
    ++refused;
  }
  CHECK(refused == text.size());
  CHECK(refused > 200);
  CHECK(!refusal(text));
  CHECK(!refusal(text + " \n"));
}

}  // namespace bezcert::test
