#include "core/io/gltf_accessor.h"

#include "core/io/mesh_bytes.h"

#include <QtCore/QByteArray>
#include <QtCore/QCoreApplication>

namespace fff::io {

namespace {

constexpr std::int64_t kMostGltf = std::int64_t(1) << 40; // of counts and offsets

struct Component
{
    std::int64_t type;
    std::size_t size;
    double most; // that stands for 1 where it is normalised
    double (*at)(const MeshBytes &, std::size_t);
};

template <class Number>
constexpr Component componentOf(std::int64_t type, double most)
{
    return {type, sizeof(Number), most, [](const MeshBytes &bytes, std::size_t at) {
                return static_cast<double>(bytes.at<Number>(at));
            }};
}

constexpr std::array kComponents = {
    componentOf<std::int8_t>(5120, 127.0),         componentOf<std::uint8_t>(5121, 255.0),
    componentOf<std::int16_t>(5122, 32767.0),      componentOf<std::uint16_t>(5123, 65535.0),
    componentOf<std::uint32_t>(5125, 4294967295.), componentOf<float>(5126, 1.0)};

std::int64_t numberOf(const JsonCursor &of, const char *name, std::int64_t otherwise)
{
    const JsonCursor value = of.member(name);
    return value.exists() ? value.integer(0, kMostGltf) : otherwise;
}

} // namespace

const JsonCursor *GltfBuffers::List::at(std::int64_t index)
{
    if (!items)
        items = cursor.items();
    if (index >= 0 && index < std::ssize(*items))
        return &(*items)[std::size_t(index)];
    cursor.fail(ErrorCode::UnknownReference, {std::to_string(index)});
    return nullptr;
}

std::string_view GltfBuffers::bytes(const JsonCursor &view, std::optional<Error> &error)
{
    const std::int64_t index = view.member("buffer").integer(0, kMostGltf);
    const auto [known, isNew] = m_buffers.try_emplace(index);
    std::string_view all = known->second;
    const JsonCursor *found = m_bufferList.at(index);
    if (!found)
        return {};
    const JsonCursor &buffer = *found;
    if (!buffer.member("uri").exists()) {
        all = m_binary;
        if (index != 0 || all.empty())
            buffer.failExpected(QT_TRANSLATE_NOOP("Error", "a buffer with bytes"));
    } else if (isNew) {
        const std::string uri = buffer.member("uri").text();
        if (uri.starts_with("data:")) {
            const std::size_t comma = std::min(uri.find(','), uri.size() - 1);
            known->second =
                QByteArray::fromBase64(
                    QByteArray::fromRawData(uri.data() + comma + 1,
                                            static_cast<qsizetype>(uri.size() - comma - 1)))
                    .toStdString();
        } else if (!m_options.beside) {
            buffer.failExpected(QT_TRANSLATE_NOOP("Error", "a buffer in the file"));
        } else {
            const QByteArray name = QByteArray::fromPercentEncoding(QByteArray::fromStdString(uri));
            Result<std::string> read = m_options.beside(name.toStdString());
            if (read)
                known->second = *std::move(read);
            else if (!error)
                error = read.error();
        }
        all = known->second;
    }
    const auto from = static_cast<std::size_t>(numberOf(view, "byteOffset", 0));
    const auto length = static_cast<std::size_t>(view.member("byteLength").integer(0, kMostGltf));
    if (error)
        return {};
    if (!MeshBytes(all).has(from, length)) {
        view.member("byteLength")
            .failExpected(QT_TRANSLATE_NOOP("Error", "a length that its buffer has"));
        return {};
    }
    return all.substr(from, length);
}

std::vector<double> GltfBuffers::numbers(std::int64_t accessor, int columns,
                                         std::optional<Error> &error)
{
    const JsonCursor *found = m_accessors.at(accessor);
    if (!found)
        return {};
    const JsonCursor &cursor = *found;
    if (cursor.member("sparse").exists()) {
        cursor.fail(ErrorCode::Unsupported, {"sparse"});
        return {};
    }
    const std::string type = cursor.member("type").text();
    if (type != (columns == 1 ? "SCALAR" : "VEC3")) {
        cursor.member("type").failExpected(columns == 1 ? "SCALAR" : "VEC3");
        return {};
    }
    const std::int64_t code = cursor.member("componentType").integer(0, kMostGltf);
    const auto *component = std::find_if(kComponents.begin(), kComponents.end(),
                                         [code](const Component &c) { return c.type == code; });
    if (component == kComponents.end()) {
        cursor.member("componentType")
            .failExpected(QT_TRANSLATE_NOOP("Error", "a type of numbers that glTF has"));
        return {};
    }
    if (!cursor.member("bufferView").exists()) {
        cursor.failExpected(QT_TRANSLATE_NOOP("Error", "a buffer with bytes"));
        return {};
    }
    const JsonCursor *of = m_views.at(cursor.member("bufferView").integer(0, kMostGltf));
    if (!of)
        return {};
    const JsonCursor &view = *of;
    const MeshBytes data(bytes(view, error));
    const auto count = static_cast<std::size_t>(cursor.member("count").integer(0, kMostGltf));
    const auto from = static_cast<std::size_t>(numberOf(cursor, "byteOffset", 0));
    const std::size_t row = component->size * std::size_t(columns);
    const auto stride =
        static_cast<std::size_t>(numberOf(view, "byteStride", static_cast<std::int64_t>(row)));
    if (error || count == 0 || stride == 0)
        return {};
    // Without a product that could be too large for its type.
    if (!data.has(from, row) || (count - 1) > (data.size() - from - row) / stride) {
        cursor.member("count").failExpected(
            QT_TRANSLATE_NOOP("Error", "as many values as its buffer has"));
        return {};
    }
    const JsonCursor normalized = cursor.member("normalized");
    const double scale = normalized.exists() && normalized.truth() ? 1.0 / component->most : 1.0;
    std::vector<double> values;
    values.reserve(count * std::size_t(columns));
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t c = 0; c < std::size_t(columns); ++c)
            values.push_back(scale * component->at(data, from + i * stride + c * component->size));
    return values;
}

} // namespace fff::io
