#!/usr/bin/env python3
"""What cpp_outline.py reads in sources as clang-format leaves them."""

import unittest

from cpp_outline import outline

FUNCTIONS = r'''
#include <vector>
#define LW_ODD(x) \
  if (x) {        \
  }
namespace latticeworld {
namespace {

constexpr std::array<EnumName<Kind>, 2> kNames = {{
    {Kind::kTree, "tree"},
    {Kind::kStone, "}}}{"},
}};
constexpr char kText[] = R"json({"a": [")", {)json";
const std::vector<int> kNumbers{1, 2};
const std::map<std::string, int> kTable = [] {
  return std::map<std::string, int>();
}();
const Row kRows[] = {
    {"a", [](int x) { return x; }},
    {"b",
     [](const A& a) -> std::vector<int> {
       return a;
     }},
};
enum class Kind : unsigned char {
  kTree,
};
static_assert(1 < 2 && 3 > 2);

// No function: void Commented() {
std::vector<int> Free(std::vector<int> given = {},
                      const std::function<void(int)>& each = [](int) {}) {
  auto inner = [&](int i) {
    return i < 1'000 ? '{' : '"';
  };
  struct Local {
    void Member() {
    }
  };
  return given;
}

struct Elaborated Made() { return {}; }
template <typename T, typename = std::enable_if_t<(sizeof(T) > 4)>>
auto Trailing(T t) -> std::pair<int, T> {
  return {1, t};
}

}  // namespace

Body::Body(int a, std::vector<int> b)
    : Base<int>{a}, a_(a), b_{std::move(b)}, c_([a] { return a; }) {
  Start();
}
Body::~Body() {
}
template <typename T>
Grid<T>& Grid<T>::operator=(const Grid<T>& other) {
  return *this;
}
bool operator<(const A& a, const A& b) { return a.x << 3 < b.x; }
int Body::operator()(int i) const noexcept { return i; }
Body::operator bool() const { return true; }
extern "C" {
void Foreign() {}
}

}  // namespace latticeworld
'''

MEMBERS = '''
class Ahead;
class Engine final : public Base, private Other<int> {
 public:
  using Base::Base;
  friend class Ahead;
  friend bool operator==(const Engine& a, const Engine& b) { return a.x_ == b.x_; }
  explicit Engine(int x) : x_(x), y_{x} {}
  ~Engine() override;
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;
  Engine(Engine&&) = default;
  [[nodiscard]] Status Start(const Options& options = {}) override;
  const std::map<int, std::string>& names() const { return names_; }
  template <typename F>
  void ForEach(F&& each) const {
    each(1);
  }
  static int Count();
  virtual void Draw() const = 0;

 private:
  enum class Mode { kOn, kOff };
  struct Row {
    int a = 0;
    void Clear() {}
  };
  struct Later;
  static constexpr int kMost = 3;
  const int x_;
  double y_ = 1.0, z_{2.0};
  std::map<int, std::string> names_;
  std::array<std::pair<int, int>, 4> pairs_ = {};
  std::function<void(int)> told_ = [](int) {};
  void (*call_)(int) = nullptr;
  float bytes_[4];
  bool on_ : 1;
  struct {
    int b;
  } place_;
  Mode mode_ = Mode::kOn;
};
'''


class OutlineTest(unittest.TestCase):
    def test_functions_are_found_with_their_lengths(self):
        found = [(function.name, function.lines) for function in outline(FUNCTIONS).functions]
        self.assertEqual([
            ("lambda of kTable", 3),
            ("lambda of kRows", 1),
            ("lambda of kRows", 3),
            ("lambda of Free", 1),
            ("Free", 10),
            ("Made", 1),
            ("Trailing", 3),
            ("lambda of Body::Body", 1),
            ("Body::Body", 3),
            ("Body::~Body", 2),
            ("Grid<T>::operator=", 3),
            ("operator<", 1),
            ("Body::operator()", 1),
            ("Body::operator bool", 1),
            ("Foreign", 1),
        ], found)

    def test_a_function_is_counted_from_its_opening_brace(self):
        function, = outline("\nvoid F(int a,\n       int b) {\n  G();\n\n}\n").functions
        self.assertEqual((3, 4), (function.line, function.lines))

    def test_functions_in_a_class_are_found(self):
        names = [function.name for function in outline(MEMBERS).functions]
        self.assertEqual(["Engine::operator==", "Engine::Engine", "Engine::names",
                          "Engine::ForEach", "Row::Clear", "lambda of told_"], names)

    def test_members_are_those_of_the_class_itself(self):
        engine, row, unnamed = outline(MEMBERS).classes
        self.assertEqual("Engine", engine.name)
        self.assertEqual(["Engine", "~Engine", "Engine", "Start", "names", "ForEach", "Count",
                          "Draw"], engine.functions)
        self.assertEqual(["x_", "y_", "z_", "names_", "pairs_", "told_", "call_", "bytes_", "on_",
                          "place_", "mode_"], engine.data)
        self.assertEqual(("Row", ["Clear"], ["a"]), (row.name, row.functions, row.data))
        self.assertEqual(("", ["b"]), (unnamed.name, unnamed.data))

    def test_what_is_no_whole_source_is_refused(self):
        for text in ("void F() {\n", "namespace a {\nint b;\n", "int a;\n}\n"):
            with self.assertRaises(ValueError):
                outline(text)


if __name__ == "__main__":
    unittest.main()
