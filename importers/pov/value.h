// SPDX-License-Identifier: Apache-2.0
/// What an expression of the scene language can be worth.
#pragma once

#include "importers/pov/lexer.h"
#include "scene/function.h"

#include <algorithm>
#include <array>
#include <memory>
#include <span>
#include <utility>

namespace alidade::pov {

/// Counted by the one thread that reads a scene.
struct Shared {
    Shared() = default;
    Shared(const Shared&) {}
    Shared& operator=(const Shared&) { return *this; }
    virtual ~Shared() = default;
    uint32_t uses = 0;
    uint32_t depth = 0;          ///< how many others stand inside one another in it: bounded, so that taking it apart is
};

/// Deletes; in a file of its own, where g++ 12 does not see it: inlined, it warns of uses after it that cannot happen.
void destroy(const Shared* unused);

/// An owning pointer to a Shared.
template <class T>
class Ref {
  public:
    Ref() = default;
    explicit Ref(T* p) : p_(p) { if (p_) ++p_->uses; }
    Ref(const Ref& other) : Ref(other.p_) {}
    Ref(Ref&& other) noexcept : p_(std::exchange(other.p_, nullptr)) {}
    Ref& operator=(Ref other) noexcept {
        std::swap(p_, other.p_);
        return *this;
    }
    ~Ref() { if (p_ && --p_->uses == 0) destroy(p_); }

    T* get() const { return p_; }
    T* operator->() const { return p_; }
    T& operator*() const { return *p_; }
    explicit operator bool() const { return p_ != nullptr; }

  private:
    T* p_ = nullptr;
};

/// `x` in single precision. Not in a register: of neighbours that it converts to float and back together, g++ 12 (-ftree-slp-vectorize) leaves the
/// rounding out.
inline double in_single(double x) {
    const volatile float rounded = float(x);
    return rounded;
}

enum class Kind : uint8_t { nothing, number, vector, colour, string, array, block, function, spline, macro, file };

constexpr bool is_numeric(Kind kind) { return kind == Kind::number || kind == Kind::vector || kind == Kind::colour; }

/// "float", "vector of 3", ...: as messages say it.
std::string kind_name(const struct Value& value);

/// Numbers, vectors and colours in place. Everything else is shared: blocks, strings ... never change; arrays are copied by whoever keeps them.
struct Value {
    Kind kind = Kind::nothing;
    uint8_t terms = 0;                 ///< number 1, vector 2..5, colour 5 (red, green, blue, filter, transmit)
    uint8_t rest = 0;                  ///< a float that a component of a vector begins (`V.y`, `V.y*2`): the other components of that, so many with it, still stand behind it in c
    std::array<double, 5> c{};
    Ref<Shared> shared;

    static Value number(double x) {
        Value v;
        v.kind = Kind::number, v.terms = 1, v.c[0] = x;
        return v;
    }
    static Value vector(uint8_t terms, const std::array<double, 5>& c) {
        Value v;
        v.kind = Kind::vector, v.terms = terms, v.c = c;
        return v;
    }
    /// Components are kept in single precision, as POV-Ray keeps them.
    static Value colour(const std::array<double, 5>& c) {
        Value v;
        v.kind = Kind::colour, v.terms = 5;
        for (int i = 0; i < 5; ++i) v.c[i] = in_single(c[i]);
        return v;
    }
    static Value string(std::string text);
    template <class T>
    static Value of(Kind kind, Ref<T> what) {
        Value v;
        v.kind = kind, v.shared = Ref<Shared>(what.get());
        return v;
    }

    bool numeric() const { return is_numeric(kind); }
    /// How many of c mean something.
    uint8_t components() const { return numeric() ? std::max(terms, rest) : uint8_t(0); }
    template <class T>
    T& as() const { return static_cast<T&>(*shared.get()); }
    const std::string& text() const;
};

struct String : Shared {
    explicit String(std::string t) : text(std::move(t)) {}
    std::string text;
};

/// What to say when an identifier is used that was declared deprecated.
struct Deprecation : Shared {
    std::string message;         ///< may be empty
    bool once = false;
};

/// What an identifier, a macro parameter or an array element holds.
struct Slot : Shared {
    Value value;
    Ref<Deprecation> deprecation;
};

/// How much of something lives at present.
struct Meter : Shared {
    uint64_t used = 0;
};

/// What an array's elements have in common: objects and lights are one kind, vectors of five are colours.
struct ElementKind {
    Kind kind = Kind::nothing;
    WordId detail = 0;            ///< the terms of a vector, the word of a block
    bool operator==(const ElementKind&) const = default;
    std::string name() const;
};
ElementKind element_kind_of(const Value& value);

/// A rectangle of slots; one that was never assigned to is empty.
struct Array : Shared {
    explicit Array(Ref<Meter> m) : meter(std::move(m)) {}
    Array(const Array&) = delete;
    Array& operator=(const Array&) = delete;
    ~Array() override { meter->used -= slots.size(); }
    void resize(std::vector<uint32_t> to, size_t elements) { sizes = std::move(to), slots.resize(elements), meter->used += elements; }

    std::vector<uint32_t> sizes;
    std::vector<Ref<Slot>> slots;
    Ref<Meter> meter;
    ElementKind element_kind;     ///< of the first that was given, which all others are of
};

/// A long vector literal `<...>` (a matrix, a polynomial) in a block.
struct NumberList : Shared {
    std::vector<double> numbers;
};

struct Block;
/// One thing in a block that is being read.
struct OpenItem;

/// One thing in a block: a word, a value, a block, or the brackets of a map's entry. There are many, so that they are kept small: of a vector or a colour the components stand behind the items of the block.
class Item {
  public:
    enum class Kind : uint8_t { word, value, numbers, block, entry };

    /// Takes what `from` holds; its components, if there are several, are copied to `room`, which moves behind them.
    Item(OpenItem&& from, double*& room);
    Item(const Item&) = delete;
    Item& operator=(const Item&) = delete;
    ~Item();

    pov::Kind value_kind() const { return value_kind_; }
    bool numeric() const { return is_numeric(value_kind_); }
    /// The first component of what is numeric.
    double number() const { return components() > 1 ? *several_ : number_; }
    Value value() const;
    template <class T>
    T& as() const { return static_cast<T&>(*shared_.get()); }
    const Block& block() const { return as<Block>(); }
    const std::string& text() const { return as<String>().text; }

    const Kind kind;

  private:
    uint8_t components() const { return numeric() ? std::max(terms_, rest_) : uint8_t(0); }

    pov::Kind value_kind_;
    uint8_t terms_, rest_;        ///< of a Value

  public:
    const WordId word;            ///< of a word or a block
    const Place place;

  private:
    union {
        double number_;
        const double* several_;
        Ref<Shared> shared_;      ///< of what is not numeric
    };
};
static_assert(sizeof(Item) == 24);

struct OpenItem {
    Item::Kind kind = Item::Kind::word;
    Place place;
    WordId word = 0;
    Value value;                  ///< of a value; a block or an entry is a Value of kind block
    pov::Kind value_kind() const { return value.kind; }
    double number() const { return value.c[0]; }
    const Block& block() const { return value.as<Block>(); }
    /// Those that stand behind the items of a block.
    size_t components_behind() const { return value.components() > 1 ? value.components() : 0; }
};

/// What held where a block began.
struct BlockStanding {
    uint32_t defaults = 0;            ///< how many #default stood before it: what is left out of a texture comes from them
    float version = 0;                ///< of the language; 3.7 where no #version was given
    bool version_given = false;
    bool gamma_given = false;         ///< by an assumed_gamma before it
};

/// `word { items }` with every expression evaluated: what builders read. Most are small and there are many, so the items lie right behind the block.
struct Block : Shared, BlockStanding {
    static constexpr size_t kWeight = 2;    ///< a block takes the memory of so many items besides its own
    /// Takes what the items hold.
    static Ref<Block> of(std::span<OpenItem> items, Ref<Meter> meter);
    Block(const Block&) = delete;
    Block& operator=(const Block&) = delete;
    ~Block() override;
    void stands(const BlockStanding& where) { static_cast<BlockStanding&>(*this) = where; }
    static void operator delete(void* block) { ::operator delete(block); }
    std::span<const Item> items() const { return {reinterpret_cast<const Item*>(this + 1), count_}; }

    WordId word = 0;
    Place place;

  private:
    struct Room {
        size_t items, components;
    };
    static void* operator new(size_t size, Room room) { return ::operator new(size + room.items * sizeof(Item) + room.components * sizeof(double)); }
    static void operator delete(void* block, Room) { ::operator delete(block); }
    Block(std::span<OpenItem> from, Ref<Meter> meter);

    uint32_t count_ = 0;

  public:
    Ref<Meter> meter;
    std::unique_ptr<std::vector<Ref<Block>>> layers;   ///< further textures of a declared layered texture; null: none
};
static_assert(sizeof(Block) % alignof(Item) == 0 && alignof(Item) == alignof(double));

/// A macro: its body is a range of tokens of a file.
struct Macro : Shared {
    WordId name = 0;
    uint16_t source = 0;
    uint32_t begin = 0, end = 0;
    std::vector<WordId> parameters;
};

/// `spline { ... }`, or `function { spline { ... } }`: functions can call that one alone.
struct Spline : Shared {
    SplineCurve curve;
    bool is_function = false;
};

/// `function(parameters) { tokens }`, `function W, H { tokens }`: what stood in the braces, with macros expanded and identifiers resolved; compiled when it is first asked.
struct Function : Shared {
    struct Part {
        Token token;
        Value value;                ///< what an identifier was worth when the function was declared
    };
    std::vector<WordId> parameters;
    std::vector<WordId> counters;   ///< that sum() and prod() in it count with
    std::vector<Part> parts;
    std::vector<std::string> texts;
    bool named = false;                       ///< its parameters are: `function(a, b)`, not `function`
    std::optional<std::array<double, 2>> size;   ///< of a picture that is made of it: columns and rows
    Place place;
};

}  // namespace alidade::pov
