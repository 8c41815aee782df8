#include "macro/macro.hpp"

#include "base/error.hpp"
#include "macro/evaluate.hpp"
#include "macro/parser.hpp"

#include <algorithm>
#include <cctype>
#include <utility>

namespace filum::macro {

namespace {

constexpr std::size_t kLongest = std::size_t{16} << 20; // bytes
constexpr std::size_t kMostItems = 100'000;
constexpr std::size_t kMostKept = std::size_t{64} << 20; // bytes

[[noreturn]] void refuse(const std::string& name, const std::string& text, const FaultAt& fault) {
    const Fault at = placed(fault, text);
    throw Error(Exit::bad_input, "cannot use " + name + ": line " + std::to_string(at.line) + ", column " +
                                     std::to_string(at.column) + ": " + at.why);
}

class Writer {
  public:
    explicit Writer(Scope& scope) { variables_.scope = &scope; }

    void write(const Block& block) {
        for (const TemplateNode& piece : block) {
            switch (piece.kind) {
            case TemplateNode::Kind::text:
                out_ += piece.text;
                break;
            case TemplateNode::Kind::expression:
                out_ += text_of(evaluate(piece.expression, variables_), variables_.scope->numbers);
                break;
            case TemplateNode::Kind::bracket:
                bracket(piece);
                break;
            case TemplateNode::Kind::branch:
                branch(piece.branch);
                break;
            case TemplateNode::Kind::assignment:
                assign(piece);
                break;
            }
            if (out_.size() > kLongest) throw FaultAt{"the text grows beyond 16 MB", piece.at};
        }
    }

    std::string take() { return std::move(out_); }

  private:
    void branch(const Branch& from) {
        for (std::size_t i = 0; i < from.blocks.size(); ++i)
            if (i >= from.conditions.size() || holds(from.conditions[i], variables_)) return write(from.blocks[i]);
    }

    // Writes [name], for a list the item of the extruder, or [name_2], the third item.
    void bracket(const TemplateNode& piece) {
        const Variable* found = variables_.find(piece.text);
        std::size_t index = variables_.scope->extruder;
        if (!piece.index.empty()) {
            if (found == nullptr && piece.text.ends_with('_'))
                found = variables_.find(piece.text.substr(0, piece.text.size() - 1));
            const Expression name{Expression::Kind::variable, {}, piece.index, {}, {}, {}, {}, piece.at};
            index = index_of(name, variables_);
            if (found != nullptr) (void)item(*found, index, piece.text, piece.at);
        } else if (const auto line = piece.text.rfind('_'); found == nullptr && line != std::string::npos) {
            const std::string number = piece.text.substr(line + 1);
            const bool digits = !number.empty() && number.size() < 10 &&
                                std::ranges::all_of(number, [](unsigned char c) { return std::isdigit(c) != 0; });
            if (digits) found = variables_.find(piece.text.substr(0, line));
            if (digits) index = std::stoul(number);
            if (found != nullptr) (void)item(*found, index, piece.text.substr(0, line), piece.at);
        }
        if (found == nullptr) throw FaultAt{"'" + piece.text + "' is no known name", piece.at};
        if (found->items.empty()) throw FaultAt{"'" + piece.text + "' is an empty list", piece.at};
        if (!found->list || index >= found->items.size()) index = 0;
        out_ += index < found->written.size() ? found->written[index]
                                              : text_of(found->items[index], variables_.scope->numbers);
    }

    // The variable that an assignment changes.
    Variable& target(const Assignment& a, std::size_t at) {
        Scope& scope = *variables_.scope;
        if (a.scope == Assignment::Scope::global) return scope.globals[a.name];
        if (a.scope == Assignment::Scope::local) return variables_.locals[a.name];
        if (const auto local = variables_.locals.find(a.name); local != variables_.locals.end()) return local->second;
        if (const auto global = scope.globals.find(a.name); global != scope.globals.end()) return global->second;
        const Variable* found = scope.find ? scope.find(a.name) : nullptr;
        if (found == nullptr)
            throw FaultAt{"'" + a.name + "' is no known name; write 'local " + a.name + " = ...' to make one", at};
        if (std::ranges::find(scope.writable, a.name) == scope.writable.end())
            throw FaultAt{"'" + a.name + "' cannot be changed; it is a setting", at};
        return variables_.locals[a.name] = *found;
    }

    std::vector<Value> values(const Assignment& a) {
        std::vector<Value> out;
        if (a.repeat) {
            const std::size_t count = index_of(a.values[0], variables_);
            if (count > kMostItems) throw FaultAt{"a list grows beyond 100000 values", a.values[0].at};
            const Value one = evaluate(a.values[1], variables_);
            keep(count * size_of(one), a.values[1].at);
            out.assign(count, one);
            return out;
        }
        for (const Expression& e : a.values) {
            out.push_back(evaluate(e, variables_));
            keep(size_of(out.back()), e.at);
        }
        return out;
    }

    static std::size_t size_of(const Value& value) {
        const auto* text = std::get_if<std::string>(&value);
        return sizeof(Value) + (text == nullptr ? 0 : text->size());
    }

    // Counts the bytes of assigned values.  Throws FaultAt beyond kMostKept.
    void keep(std::size_t bytes, std::size_t at) {
        kept_ += bytes;
        if (kept_ > kMostKept) throw FaultAt{"its variables hold more than 64 MB", at};
    }

    void assign(const TemplateNode& piece) {
        const Assignment& a = piece.assignment;
        const Expression& first = a.values.empty() ? Expression{} : a.values[0];
        Variable made;
        // An assignment of a bare name copies its list.
        const Variable* source =
            !a.list && !a.repeat && first.kind == Expression::Kind::variable ? variables_.find(first.name) : nullptr;
        if (source != nullptr && source->list && a.index.empty()) {
            made = *source;
            for (const Value& v : made.items) keep(size_of(v), piece.at);
        } else {
            made.list = a.list || a.repeat;
            made.items = values(a);
        }
        if (a.index.empty()) {
            target(a, piece.at) = std::move(made);
            return;
        }
        const std::size_t index = index_of(a.index[0], variables_);
        Variable& to = target(a, piece.at);
        if (!to.list || made.list) throw FaultAt{"'" + a.name + "' has no items to set", piece.at};
        if (index >= to.items.size())
            throw FaultAt{"'" + a.name + "' has " + std::to_string(to.items.size()) + " values; there is no number " +
                              std::to_string(index),
                          piece.at};
        to.items[index] = std::move(made.items[0]);
        to.written.clear();
    }

    Variables variables_;
    std::string out_;
    std::size_t kept_ = 0; // bytes of all assigned values
};

// Finds names that are not defined.
class NameCheck {
  public:
    explicit NameCheck(const std::function<bool(std::string_view)>& known) : known_(known) {}

    void check(const Block& block) {
        for (const TemplateNode& p : block) {
            check(p.expression);
            if (p.kind == TemplateNode::Kind::bracket) check(p.text, p.at);
            for (const Expression& e : p.branch.conditions) check(e);
            for (const Block& b : p.branch.blocks) check(b);
            for (const Expression& e : p.assignment.values) check(e);
            if (p.kind == TemplateNode::Kind::assignment) own_.push_back(p.assignment.name);
        }
    }

  private:
    void check(const Expression& e) {
        if (e.kind == Expression::Kind::variable || e.kind == Expression::Kind::item) check(e.name, e.at);
        for (const Expression& part : e.parts) check(part);
    }

    void check(const std::string& name, std::size_t at) {
        if (!known_(name) && std::ranges::find(own_, name) == own_.end())
            throw FaultAt{"'" + name + "' is no known name", at};
    }

    const std::function<bool(std::string_view)>& known_;
    std::vector<std::string> own_;
};

} // namespace

Template parsed(const std::string& name, const std::string& text, Style style) {
    try {
        return {name, text, std::make_shared<const Block>(parse(text, style))};
    } catch (const FaultAt& fault) {
        refuse(name, text, fault);
    }
}

std::string expand(const Template& from, Scope& scope) {
    Writer writer(scope);
    try {
        if (from.block != nullptr) writer.write(*from.block);
    } catch (const FaultAt& fault) {
        refuse(from.name, from.text, fault);
    }
    return writer.take();
}

std::optional<Fault> fault(std::string_view text, Style style, const std::function<bool(std::string_view)>& known) {
    try {
        NameCheck(known).check(parse(text, style));
        return {};
    } catch (const FaultAt& wrong) {
        return placed(wrong, text);
    }
}

} // namespace filum::macro
