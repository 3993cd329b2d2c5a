<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
<context>
    <name>AssemblySteps</name>
    <message numerus="yes">
        <source>%n parts as one</source>
        <translation>
            <numerusform>合为一体的 %n 个零件</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 (part %2)</source>
        <extracomment>%1 is a section&apos;s name, %2 the number engraved on one of its parts</extracomment>
        <translation>%1（零件 %2）</translation>
    </message>
    <message>
        <source>%1 (together since step %2)</source>
        <extracomment>%1 is what is moved, %2 the number of the step that completed it</extracomment>
        <translation>%1（第 %2 步已拼好）</translation>
    </message>
    <message numerus="yes">
        <source>%n others</source>
        <translation>
            <numerusform>另外 %n 个</numerusform>
        </translation>
    </message>
    <message>
        <source>up</source>
        <comment>direction of a way</comment>
        <translation>向上</translation>
    </message>
    <message>
        <source>down</source>
        <comment>direction of a way</comment>
        <translation>向下</translation>
    </message>
    <message>
        <source>to the right</source>
        <comment>direction of a way</comment>
        <translation>向右</translation>
    </message>
    <message>
        <source>to the left</source>
        <comment>direction of a way</comment>
        <translation>向左</translation>
    </message>
    <message>
        <source>to the front</source>
        <comment>direction of a way</comment>
        <translation>向前</translation>
    </message>
    <message>
        <source>to the back</source>
        <comment>direction of a way</comment>
        <translation>向后</translation>
    </message>
    <message>
        <source>along the arrow</source>
        <comment>direction of a way</comment>
        <translation>沿箭头方向</translation>
    </message>
    <message>
        <source>There is no section yet, so there are no steps.</source>
        <translation>还没有插片，所以没有步骤。</translation>
    </message>
    <message>
        <source>Nothing is cut from this model, so there are no steps.</source>
        <translation>这个模型没有要切割的东西，所以没有步骤。</translation>
    </message>
    <message>
        <source>No steps to show: %1.</source>
        <extracomment>%1 is a sentence such as &quot;the solid of &quot;Rib&quot; could not be worked out&quot;</extracomment>
        <translation>没有可显示的步骤：%1。</translation>
    </message>
    <message>
        <source>No steps to show: the order of assembly was not found in time.</source>
        <translation>没有可显示的步骤：没能及时找到拼装顺序。</translation>
    </message>
    <message numerus="yes">
        <source>No steps to show: the model cannot be assembled, since %n sections block each other.</source>
        <translation>
            <numerusform>没有可显示的步骤：有 %n 个插片互相卡住，模型无法拼装。</numerusform>
        </translation>
    </message>
    <message>
        <source>No steps to show: the model cannot be assembled, since parts of %1 block each other.</source>
        <translation>没有可显示的步骤：%1 的零件互相卡住，模型无法拼装。</translation>
    </message>
    <message>
        <source>No steps to show: the model cannot be assembled, since %1 block each other.</source>
        <translation>没有可显示的步骤：%1 互相卡住，模型无法拼装。</translation>
    </message>
    <message>
        <source>Step %1 of %2</source>
        <translation>第 %1 步，共 %2 步</translation>
    </message>
    <message>
        <source>start with %1</source>
        <translation>从 %1 开始</translation>
    </message>
    <message>
        <source>start a group of its own with %1</source>
        <translation>从 %1 开始另拼一组</translation>
    </message>
    <message>
        <source>put %1 in place</source>
        <translation>把 %1 放到位</translation>
    </message>
    <message>
        <source>bring %1 in round the corner, finally %2</source>
        <extracomment>%1 is what is moved, %2 a direction such as &quot;down&quot;</extracomment>
        <translation>把 %1 绕过拐角送入，最后%2推到位</translation>
    </message>
    <message>
        <source>bring %1 in round the corner, then slide it %2 into %3</source>
        <extracomment>%1 is what is moved, %2 a direction such as &quot;down&quot;, %3 what it is put into</extracomment>
        <translation>把 %1 绕过拐角送入，再%2插入 %3</translation>
    </message>
    <message>
        <source>move %1 %2 into place</source>
        <extracomment>%1 is what is moved, %2 a direction such as &quot;down&quot;</extracomment>
        <translation>把 %1 %2推到位</translation>
    </message>
    <message>
        <source>slide %1 %2 into %3</source>
        <extracomment>%1 is what is moved, %2 a direction such as &quot;down&quot;, %3 what it is put into</extracomment>
        <translation>把 %1 %2插入 %3</translation>
    </message>
</context>
<context>
    <name>Checks</name>
    <message>
        <source>Holds %1 more here before %2 cracks %3.</source>
        <extracomment>%1 is a mass, %2 a section, %3 a place such as &quot;beside its slit for Body&quot;</extracomment>
        <translation>这里还能承受 %1，再重的话 %2 会在%3开裂。</translation>
    </message>
    <message>
        <source>Holds %1 here before %2 cracks %3.</source>
        <translation>这里能承受 %1，再重的话 %2 会在%3开裂。</translation>
    </message>
    <message>
        <source>Holds %1 more here before it falls over.</source>
        <extracomment>%1 is a mass</extracomment>
        <translation>这里还能承受 %1，再重就会翻倒。</translation>
    </message>
    <message>
        <source>Holds %1 here before it falls over.</source>
        <translation>这里能承受 %1，再重就会翻倒。</translation>
    </message>
    <message>
        <source>Holds %1 more here before a joint is pulled open.</source>
        <extracomment>%1 is a mass</extracomment>
        <translation>这里还能承受 %1，再重就会有接头被拉开。</translation>
    </message>
    <message>
        <source>Holds %1 here before a joint is pulled open.</source>
        <translation>这里能承受 %1，再重就会有接头被拉开。</translation>
    </message>
    <message>
        <source>Holds more than %1 here.</source>
        <extracomment>%1 is a mass</extracomment>
        <translation>这里能承受 %1 以上。</translation>
    </message>
    <message>
        <source>How much it holds here could not be worked out.</source>
        <translation>无法算出这里能承受多少。</translation>
    </message>
    <message>
        <source>Widen the base</source>
        <translation>加宽底部</translation>
    </message>
    <message>
        <source>Add a foot</source>
        <translation>加一个支脚</translation>
    </message>
    <message>
        <source>Connected. Only one section so far.</source>
        <translation>连成一体。目前只有一个插片。</translation>
    </message>
    <message>
        <source>1 joint</source>
        <translation>1 个接头</translation>
    </message>
    <message numerus="yes">
        <source>%n joints</source>
        <translation>
            <numerusform>%n 个接头</numerusform>
        </translation>
    </message>
    <message>
        <source>Connected. Both sections, by %1.</source>
        <translation>连成一体。两个插片由 %1相连。</translation>
    </message>
    <message>
        <source>Connected. All %1 sections, by %2.</source>
        <translation>连成一体。全部 %1 个插片由 %2相连。</translation>
    </message>
    <message>
        <source>Would be connected %1.</source>
        <extracomment>%1 is such as &quot;if nothing fell apart&quot;</extracomment>
        <translation>%1，本可连成一体。</translation>
    </message>
    <message>
        <source>%1 is not joined to the rest.</source>
        <translation>%1 没有与其余部分相连。</translation>
    </message>
    <message>
        <source>%1 are not joined to the rest.</source>
        <translation>%1 没有与其余部分相连。</translation>
    </message>
    <message>
        <source>%1 meets %2, but nothing holds them together.</source>
        <translation>%1 碰到 %2，但没有东西把它们固定在一起。</translation>
    </message>
    <message>
        <source>%1 meet %2, but nothing holds them together.</source>
        <translation>%1 碰到 %2，但没有东西把它们固定在一起。</translation>
    </message>
    <message>
        <source>Nothing touches %1. It is %2 away from %3.</source>
        <translation>没有东西碰到 %1。它离 %3 有 %2。</translation>
    </message>
    <message>
        <source>Nothing else touches %1. They are %2 away from %3.</source>
        <translation>没有别的东西碰到 %1。它们离 %3 有 %2。</translation>
    </message>
    <message>
        <source>Delete it</source>
        <translation>删除它</translation>
    </message>
    <message>
        <source>Delete them</source>
        <translation>全部删除</translation>
    </message>
    <message>
        <source>Connected</source>
        <translation>连成一体</translation>
    </message>
    <message>
        <source>Would be connected</source>
        <translation>本可连成一体</translation>
    </message>
    <message>
        <source>Not connected</source>
        <translation>没有连成一体</translation>
    </message>
    <message>
        <source>Draw a section that crosses both, or move one of them to the other.</source>
        <translation>画一个横穿两者的插片，或把其中一个移到另一个那里。</translation>
    </message>
    <message>
        <source>Not connected yet</source>
        <translation>还没连成一体</translation>
    </message>
    <message>
        <source>if it held together</source>
        <translation>如果能连成一体</translation>
    </message>
    <message>
        <source>if nothing fell apart</source>
        <translation>如果没有散架</translation>
    </message>
    <message>
        <source>if the kerf closed no slit</source>
        <translation>如果切缝没有填没插槽</translation>
    </message>
    <message>
        <source>if no slit were too tight</source>
        <translation>如果没有插槽太紧</translation>
    </message>
    <message>
        <source>if no slit were too wide</source>
        <translation>如果没有插槽太宽</translation>
    </message>
    <message>
        <source>if it did not fold</source>
        <translation>如果不折倒</translation>
    </message>
    <message>
        <source>if it did not slide away</source>
        <translation>如果不滑走</translation>
    </message>
    <message>
        <source>if nothing came loose</source>
        <translation>如果没有松脱</translation>
    </message>
    <message>
        <source>if no joint were pulled open</source>
        <translation>如果没有接头被拉开</translation>
    </message>
    <message>
        <source>if nothing pushed it</source>
        <translation>如果没有推力</translation>
    </message>
    <message>
        <source>End one at the other</source>
        <translation>让一个在另一个处结束</translation>
    </message>
    <message>
        <source>End %1 at %2</source>
        <extracomment>%1 and %2 are names of sections</extracomment>
        <translation>让 %1 在 %2 处结束</translation>
    </message>
    <message>
        <source>Their joint is set to “None”.</source>
        <translation>它们的接头设成了“无”。</translation>
    </message>
    <message>
        <source>No slit lets them slide together: the negative clearance leaves it no width. Make the clearance larger.</source>
        <translation>没有插槽能让它们插到一起：负间隙使插槽没有宽度。请加大间隙。</translation>
    </message>
    <message>
        <source>No slits let them slide together: in one place they could only slide one way, in another only the other way. Shorten one of them.</source>
        <translation>没有插槽能让它们插到一起：有一处只能朝一个方向插，另一处只能朝反方向插。请缩短其中一个。</translation>
    </message>
    <message>
        <source>Nothing would hold them: holes are where slits would begin. Make the holes smaller, or let one of them end inside the other.</source>
        <translation>没有东西能固定它们：插槽起点处正好是孔。请把孔改小，或让其中一个在另一个里面结束。</translation>
    </message>
    <message>
        <source>No slit lets them slide together: neither of them reaches the edge. Open a hole to the outside, or let one of them pass through.</source>
        <translation>没有插槽能让它们插到一起：两者都够不到边缘。请把一个孔开到外面，或让其中一个穿过去。</translation>
    </message>
    <message>
        <source>%1 and %2 overlap, %3 long. %4</source>
        <translation>%1 和 %2 重叠，长 %3。%4</translation>
    </message>
    <message>
        <source>less than %1</source>
        <translation>不到 %1</translation>
    </message>
    <message>
        <source>%1 and %2 overlap by %3, outside their slits.</source>
        <translation>%1 和 %2 在插槽之外重叠 %3。</translation>
    </message>
    <message>
        <source>%1 and %2 overlap by %3, but are not joined.</source>
        <translation>%1 和 %2 重叠 %3，但没有连接。</translation>
    </message>
    <message>
        <source>%1 and %2 almost lie in one plane: they meet at %3, and below %4 no slit can hold them.</source>
        <translation>%1 和 %2 几乎在同一平面：相交角度为 %3，低于 %4 时没有插槽能固定它们。</translation>
    </message>
    <message>
        <source>%1 and %2 meet at %3; slits get wide below %4.</source>
        <translation>%1 和 %2 相交角度为 %3；低于 %4 时插槽会变宽。</translation>
    </message>
    <message>
        <source>Move one of them aside, or let it end before the other.</source>
        <translation>把其中一个移开，或让它在另一个之前结束。</translation>
    </message>
    <message>
        <source>Sections overlap</source>
        <translation>插片重叠</translation>
    </message>
    <message>
        <source>Angle too flat</source>
        <translation>角度太平</translation>
    </message>
    <message>
        <source>Turn one of them to a steeper angle.</source>
        <translation>把其中一个转得更陡。</translation>
    </message>
    <message>
        <source>Join them</source>
        <translation>连接它们</translation>
    </message>
    <message>
        <source>Join it with %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>与 %1 连接</translation>
    </message>
    <message>
        <source>Join them with %1</source>
        <translation>与 %1 连接</translation>
    </message>
    <message>
        <source>Move it to %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>移到 %1</translation>
    </message>
    <message>
        <source>Move them to %1</source>
        <translation>都移到 %1</translation>
    </message>
    <message>
        <source>Trim %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>修剪 %1</translation>
    </message>
    <message>
        <source>Join with tabs</source>
        <translation>用榫头连接</translation>
    </message>
    <message>
        <source>%1 does not hold %2: its slit runs along its edge and has material on one side only.</source>
        <extracomment>%1 and %2 are names of sections</extracomment>
        <translation>%1 固定不住 %2：它的插槽沿着边缘走，只有一侧有材料。</translation>
    </message>
    <message>
        <source>%1 does not hold %2: its slits cut it right through there.</source>
        <extracomment>%1 and %2 are names of sections</extracomment>
        <translation>%1 固定不住 %2：它的插槽在那里把它切断了。</translation>
    </message>
    <message>
        <source>%1 does not hold %2: its slit is less than %3 deep.</source>
        <extracomment>%1 and %2 are names of sections, %3 is a length</extracomment>
        <translation>%1 固定不住 %2：它的插槽深不到 %3。</translation>
    </message>
    <message>
        <source>%1 does not hold %2: its slit leaves no material on either side.</source>
        <extracomment>%1 and %2 are names of sections</extracomment>
        <translation>%1 固定不住 %2：它的插槽两侧都没有留下材料。</translation>
    </message>
    <message>
        <source>%1 does not hold %2: other slits take away what would be in its slit.</source>
        <extracomment>%1 and %2 are names of sections</extracomment>
        <translation>%1 固定不住 %2：本该插在它插槽里的部分被别的插槽切掉了。</translation>
    </message>
    <message>
        <source>Move the slit in from the edge.</source>
        <translation>把插槽从边缘往里移。</translation>
    </message>
    <message>
        <source>Let one of the sections that cross there end before the others, or move it aside.</source>
        <translation>让在那里相交的插片之一在其他插片之前结束，或把它移开。</translation>
    </message>
    <message>
        <source>Slit holds nothing</source>
        <translation>插槽固定不住</translation>
    </message>
    <message>
        <source>Slits cut %1 into %2 parts</source>
        <extracomment>%1 is the name of a section, %2 a number from 2 on</extracomment>
        <translation>插槽把 %1 切成 %2 个零件</translation>
    </message>
    <message>
        <source>%1 comes out in %2 parts</source>
        <translation>%1 切出来是 %2 个零件</translation>
    </message>
    <message>
        <source>%1; nothing holds one of them, %2.</source>
        <extracomment>%1 is such as &quot;Slits cut Body into 2 parts&quot;, %2 a size</extracomment>
        <translation>%1；其中一个没有东西固定，大小 %2。</translation>
    </message>
    <message>
        <source>%1; nothing holds them, the largest being %2.</source>
        <extracomment>%1 is such as &quot;Slits cut Body into 2 parts&quot;, %2 a size</extracomment>
        <translation>%1；它们都没有东西固定，最大的为 %2。</translation>
    </message>
    <message>
        <source>%1; nothing holds %2 of them, the largest being %3.</source>
        <extracomment>%1 is such as &quot;Slits cut Body into 4 parts&quot;, %2 a number from 2 on, %3 a size</extracomment>
        <translation>%1；其中 %2 个没有东西固定，最大的为 %3。</translation>
    </message>
    <message>
        <source>Slits cut %1 apart. Nothing holds what is cut off, which hangs together.</source>
        <extracomment>%1 names sections</extracomment>
        <translation>插槽把 %1 切断。切下的部分连在一起，但没有东西固定。</translation>
    </message>
    <message>
        <source>Slits cut %1 apart. Nothing holds what is cut off, together with %2.</source>
        <extracomment>%1 and %2 name sections</extracomment>
        <translation>插槽把 %1 切断。切下的部分连同 %2 都没有东西固定。</translation>
    </message>
    <message>
        <source>Slits cut %1 apart. Nothing holds its part of %2 with %3.</source>
        <extracomment>%1 is the name of a section, %2 a size, %3 names of sections</extracomment>
        <translation>插槽把 %1 切断。其中 %2 的一块连同 %3 没有东西固定。</translation>
    </message>
    <message>
        <source>Flip slits</source>
        <translation>翻转插槽</translation>
    </message>
    <message>
        <source>Loose parts</source>
        <translation>零件松散</translation>
    </message>
    <message>
        <source>Move %1 in from the edge</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>把 %1 从边缘往里移</translation>
    </message>
    <message>
        <source>Move %1 away</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>把 %1 移开</translation>
    </message>
    <message>
        <source>Make the slit shallower</source>
        <translation>把插槽改浅</translation>
    </message>
    <message>
        <source>Slit %1 is closed by the kerf of %2. Give the stock&apos;s slits more clearance, or less kerf.</source>
        <translation>插槽 %1 会被 %2 的切缝填没。请加大这种材料的插槽间隙，或减小切缝。</translation>
    </message>
    <message>
        <source>Slit %1 is narrower than the %2 tool. Give the stock&apos;s slits more clearance, or choose a thinner tool.</source>
        <translation>插槽 %1 比 %2 的刀具还窄。请加大这种材料的插槽间隙，或换更细的刀具。</translation>
    </message>
    <message>
        <source>Between their bumps slits are %1 narrower than what goes into them. That is too tight for any material: make the bumps smaller.</source>
        <translation>插槽在凸点之间比要插入的部分窄 %1。这对任何材料都太紧：请把凸点改小。</translation>
    </message>
    <message>
        <source>Slits are %1 narrower than what goes into them. That is too tight for any material.</source>
        <translation>插槽比要插入的部分窄 %1。这对任何材料都太紧。</translation>
    </message>
    <message>
        <source>Slits are %1 wider than what goes into them, so it sits loosely.</source>
        <translation>插槽比要插入的部分宽 %1，会松动。</translation>
    </message>
    <message>
        <source>Set the clearance</source>
        <translation>设置间隙</translation>
    </message>
    <message>
        <source>Slits too tight</source>
        <translation>插槽太紧</translation>
    </message>
    <message>
        <source>Slits too wide</source>
        <translation>插槽太宽</translation>
    </message>
    <message>
        <source>Slit narrower than the tool</source>
        <translation>插槽比刀具窄</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>重试</translation>
    </message>
    <message>
        <source>Show the copy for a report</source>
        <translation>显示用于报告的副本</translation>
    </message>
    <message>
        <source>Not worked out</source>
        <translation>未算出</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>%1 names sections, %2 is a sentence about them such as &quot;Falls over forwards.&quot;</extracomment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Can be assembled. Only one part so far.</source>
        <translation>可以拼装。目前只有一个零件。</translation>
    </message>
    <message>
        <source>Can be assembled. But nothing holds one of the parts.</source>
        <translation>可以拼装。但有一个零件没有东西固定。</translation>
    </message>
    <message numerus="yes">
        <source>Can be assembled. But nothing holds %n of the parts.</source>
        <translation>
            <numerusform>可以拼装。但有 %n 个零件没有东西固定。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Can be assembled. %n steps.</source>
        <translation>
            <numerusform>可以拼装。共 %n 步。</numerusform>
        </translation>
    </message>
    <message>
        <source>Could be assembled %1.</source>
        <extracomment>%1 is such as &quot;if nothing fell apart&quot;</extracomment>
        <translation>%1，本可拼装。</translation>
    </message>
    <message>
        <source>Cannot be assembled yet. It could be if two sections did not overlap.</source>
        <translation>还无法拼装。如果有两个插片不重叠就可以。</translation>
    </message>
    <message numerus="yes">
        <source>Cannot be assembled yet. It could be if %n pairs of sections did not overlap.</source>
        <translation>
            <numerusform>还无法拼装。如果有 %n 对插片不重叠就可以。</numerusform>
        </translation>
    </message>
    <message>
        <source>Show the steps</source>
        <translation>显示步骤</translation>
    </message>
    <message>
        <source>Sections block each other. %1 meet in %2 that slide in %3 different directions.</source>
        <translation>插片互相卡住。%1 相交于 %2，插入方向却有 %3 个。</translation>
    </message>
    <message>
        <source>Sections block each other. %1 comes only %2 out of its slit before it hits %3.</source>
        <translation>插片互相卡住。%1 从插槽里只能拔出 %2，就会碰到 %3。</translation>
    </message>
    <message>
        <source>Sections block each other. None of %1 can be removed in a straight line.</source>
        <translation>插片互相卡住。%1 中没有一个能沿直线拔出。</translation>
    </message>
    <message>
        <source>Make assemblable</source>
        <translation>改成可拼装</translation>
    </message>
    <message>
        <source>1 joint flipped.</source>
        <translation>翻转 1 个接头。</translation>
    </message>
    <message numerus="yes">
        <source>%n joints flipped.</source>
        <translation>
            <numerusform>翻转 %n 个接头。</numerusform>
        </translation>
    </message>
    <message>
        <source>Order not found: %1.</source>
        <extracomment>%1 is a sentence such as &quot;the solid of &quot;Rib&quot; could not be worked out&quot;</extracomment>
        <translation>未找到顺序：%1。</translation>
    </message>
    <message>
        <source>Order not found. The search took too long; that says nothing about the model.</source>
        <translation>未找到顺序。搜索时间太长；这并不说明模型有问题。</translation>
    </message>
    <message>
        <source>Can be assembled</source>
        <translation>可以拼装</translation>
    </message>
    <message>
        <source>Could be assembled</source>
        <translation>本可拼装</translation>
    </message>
    <message>
        <source>Cannot be assembled yet</source>
        <translation>还无法拼装</translation>
    </message>
    <message>
        <source>Cannot be assembled</source>
        <translation>无法拼装</translation>
    </message>
    <message>
        <source>Shorten one of them, or turn it so that it slides in the same direction as the others.</source>
        <translation>缩短其中一个，或转动它，让它与其他插片朝同一方向插入。</translation>
    </message>
    <message>
        <source>Order not found</source>
        <translation>未找到顺序</translation>
    </message>
    <message>
        <source>Pulled open. The joint of %1 and %2 is pulled apart by %3 N.</source>
        <extracomment>%3 is a number of newtons</extracomment>
        <translation>被拉开。%1 和 %2 的接头被 %3 N 的力拉开。</translation>
    </message>
    <message>
        <source>Carries nothing. The joint of %1 and %2 is pulled apart by %3 N; the others hold without it.</source>
        <translation>不受力。%1 和 %2 的接头被 %3 N 的力拉开；没有它，其他接头也撑得住。</translation>
    </message>
    <message>
        <source>Held by friction. The joint of %1 and %2 is pulled with %3 N, which only a tight fit holds.</source>
        <extracomment>%3 is a number of newtons</extracomment>
        <translation>靠摩擦固定。%1 和 %2 的接头受 %3 N 的拉力，只有配合够紧才拉不开。</translation>
    </message>
    <message>
        <source>Pulled open</source>
        <translation>被拉开</translation>
    </message>
    <message>
        <source>Carries nothing</source>
        <translation>不受力</translation>
    </message>
    <message>
        <source>Flip its slits</source>
        <translation>翻转它的插槽</translation>
    </message>
    <message>
        <source>Glue it.</source>
        <translation>请粘牢。</translation>
    </message>
    <message>
        <source>Held by friction</source>
        <translation>靠摩擦固定</translation>
    </message>
    <message>
        <source>Pushed over. Without its pushes it would stand.</source>
        <translation>被推倒。没有推力时它能站稳。</translation>
    </message>
    <message>
        <source>Pushed over</source>
        <translation>被推倒</translation>
    </message>
    <message>
        <source>Give it a broader base or more weight, or push less, or lower down.</source>
        <translation>让底部更宽或加些重量，或者推得轻一点、低一点。</translation>
    </message>
    <message>
        <source>%1 are joined in a ring: put them together in the order of the steps.</source>
        <translation>%1 连成一圈：请按步骤的顺序拼装。</translation>
    </message>
    <message>
        <source>%1 are joined in a ring: whichever goes in last has to slide onto two others at once.</source>
        <translation>%1 连成一圈：无论哪一个最后装，都要同时插到另外两个上。</translation>
    </message>
    <message numerus="yes">
        <source>Sections are joined in %n rings: put them together in the order of the steps.</source>
        <translation>
            <numerusform>插片连成了 %n 圈：请按步骤的顺序拼装。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Sections are joined in %n rings: whichever of a ring goes in last has to slide onto two others at once.</source>
        <translation>
            <numerusform>插片连成了 %n 圈：每一圈里无论哪一个最后装，都要同时插到另外两个上。</numerusform>
        </translation>
    </message>
    <message>
        <source>Joined in a ring</source>
        <translation>连成一圈</translation>
    </message>
    <message>
        <source>Support it with a foot</source>
        <translation>用支脚撑住</translation>
    </message>
    <message>
        <source>1 sheet</source>
        <translation>1 张板材</translation>
    </message>
    <message numerus="yes">
        <source>%n sheets</source>
        <translation>
            <numerusform>%n 张板材</numerusform>
        </translation>
    </message>
    <message>
        <source>Fits the sheet. %1, %2 % used.</source>
        <translation>板材放得下。%1，利用率 %2 %。</translation>
    </message>
    <message>
        <source>Fits the sheet. %1 of %2, %3 % used.</source>
        <translation>板材放得下。%1（%2），利用率 %3 %。</translation>
    </message>
    <message>
        <source>%1 parts of %2 fit no sheet of %3 with a margin of %4, however they are turned.</source>
        <translation>%2 的 %1 个零件，不论怎么转，都放不进边距为 %4 的 %3 板材。</translation>
    </message>
    <message>
        <source>%1 measures %2 and fits no sheet of %3 with a margin of %4, however it is turned.</source>
        <translation>%1 的尺寸为 %2，不论怎么转，都放不进边距为 %4 的 %3 板材。</translation>
    </message>
    <message>
        <source>Choose a sheet</source>
        <translation>选择板材</translation>
    </message>
    <message>
        <source>Fits the sheet</source>
        <translation>板材放得下</translation>
    </message>
    <message>
        <source>Too large for the sheet</source>
        <translation>板材放不下</translation>
    </message>
    <message>
        <source>Stretch them to the ground</source>
        <translation>全部延长到地面</translation>
    </message>
    <message>
        <source>Stretch %1 to the ground</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>把 %1 延长到地面</translation>
    </message>
    <message>
        <source>Drop it to the ground</source>
        <translation>落到地面</translation>
    </message>
    <message>
        <source>Raise it to the ground</source>
        <translation>抬到地面</translation>
    </message>
    <message>
        <source>Stands, but rocks by %1. Tips only past %2. Margin %3.</source>
        <translation>能站稳，但会摇晃 %1。倾斜超过 %2 才会翻倒，余量 %3。</translation>
    </message>
    <message>
        <source>Stands. Tips only past %1. Margin %2.</source>
        <translation>能站稳。倾斜超过 %1 才会翻倒，余量 %2。</translation>
    </message>
    <message>
        <source>Stands, %1 aslant. Tips only past %2. Margin %3.</source>
        <translation>能站稳，但歪斜 %1。倾斜超过 %2 才会翻倒，余量 %3。</translation>
    </message>
    <message>
        <source>The lowest point of %1 is %2 above the ground.</source>
        <translation>%1 的最低点离地面 %2。</translation>
    </message>
    <message>
        <source>The lowest points of %1 are up to %2 above the ground.</source>
        <translation>%1 的最低点离地面最多 %2。</translation>
    </message>
    <message>
        <source>Leans %1 forwards</source>
        <translation>向前倾斜 %1</translation>
    </message>
    <message>
        <source>Leans %1 backwards</source>
        <translation>向后倾斜 %1</translation>
    </message>
    <message>
        <source>Leans %1 to its left</source>
        <translation>向它的左侧倾斜 %1</translation>
    </message>
    <message>
        <source>Leans %1 to its right</source>
        <translation>向它的右侧倾斜 %1</translation>
    </message>
    <message>
        <source>Rocks by %1: its lowest points are not all on the ground. Tips only past %2.</source>
        <translation>会摇晃 %1：最低点没有都落在地面上。倾斜超过 %2 才会翻倒。</translation>
    </message>
    <message>
        <source>%1 before it stands: its lowest points are not all on the ground. Tips only past %2.</source>
        <translation>站住前会%1：最低点没有都落在地面上。倾斜超过 %2 才会翻倒。</translation>
    </message>
    <message>
        <source>Would stand %1. It would tip only past %2. Margin %3.</source>
        <extracomment>%1 is such as &quot;if it did not fold&quot;; %2 an angle, %3 a length</extracomment>
        <translation>%1，本可站稳。倾斜超过 %2 才会翻倒，余量 %3。</translation>
    </message>
    <message>
        <source>Falls at a touch: tilted by %1 it tips over. Margin %2.</source>
        <translation>一碰就倒：倾斜 %1 就会翻倒。余量 %2。</translation>
    </message>
    <message>
        <source>Barely stands: tilted by %1 it tips over. Margin %2.</source>
        <translation>勉强站住：倾斜 %1 就会翻倒。余量 %2。</translation>
    </message>
    <message>
        <source>Rocks</source>
        <translation>会摇晃</translation>
    </message>
    <message>
        <source>Leans</source>
        <translation>会倾斜</translation>
    </message>
    <message>
        <source>Falls at a touch</source>
        <translation>一碰就倒</translation>
    </message>
    <message>
        <source>Tips easily</source>
        <translation>容易翻倒</translation>
    </message>
    <message>
        <source>Falls over forwards. The centre of mass lies %1 in front of the feet.</source>
        <translation>向前翻倒。重心在支脚前方 %1 处。</translation>
    </message>
    <message>
        <source>Falls over backwards. The centre of mass lies %1 behind the feet.</source>
        <translation>向后翻倒。重心在支脚后方 %1 处。</translation>
    </message>
    <message>
        <source>Falls over to its left. The centre of mass lies %1 outside its feet.</source>
        <translation>向它的左侧翻倒。重心在支脚外侧 %1 处。</translation>
    </message>
    <message>
        <source>Falls over to its right. The centre of mass lies %1 outside its feet.</source>
        <translation>向它的右侧翻倒。重心在支脚外侧 %1 处。</translation>
    </message>
    <message>
        <source>Falls over. Its feet are all on one line, so nothing holds it upright.</source>
        <translation>会翻倒。支脚全在一条直线上，没有东西撑住它。</translation>
    </message>
    <message>
        <source>Not on the ground. Their lowest point is %1 above it.</source>
        <translation>不在地面上。它们的最低点离地面 %1。</translation>
    </message>
    <message>
        <source>Not on the ground. Its lowest point is %1 above it.</source>
        <translation>不在地面上。最低点离地面 %1。</translation>
    </message>
    <message>
        <source>Give it another foot, or move weight over its feet.</source>
        <translation>再加一个支脚，或把重量移到支脚上方。</translation>
    </message>
    <message>
        <source>Join it to what stands, or move it to the ground.</source>
        <translation>把它与站着的部分连接，或把它移到地面。</translation>
    </message>
    <message>
        <source>Does not stand yet</source>
        <translation>还站不稳</translation>
    </message>
    <message>
        <source>Not on the ground yet</source>
        <translation>还不在地面上</translation>
    </message>
    <message>
        <source>Stands</source>
        <translation>能站稳</translation>
    </message>
    <message>
        <source>Would stand</source>
        <translation>本可站稳</translation>
    </message>
    <message>
        <source>Make all its feet end at the same height.</source>
        <translation>让所有支脚的底端一样高。</translation>
    </message>
    <message>
        <source>Falls over</source>
        <translation>会翻倒</translation>
    </message>
    <message>
        <source>Not on the ground</source>
        <translation>不在地面上</translation>
    </message>
    <message>
        <source>%1 times as much</source>
        <extracomment>%1 is a number such as 2.5, of all weights and pushes</extracomment>
        <translation>%1 倍载荷</translation>
    </message>
    <message>
        <source>its load</source>
        <translation>它的载荷</translation>
    </message>
    <message>
        <source>Strong enough</source>
        <translation>够结实</translation>
    </message>
    <message>
        <source>Holds %1</source>
        <extracomment>%1 is a mass or a force</extracomment>
        <translation>能承受 %1</translation>
    </message>
    <message>
        <source>Would be strong enough</source>
        <translation>本来够结实</translation>
    </message>
    <message>
        <source>Would hold %1</source>
        <extracomment>%1 is a mass or a force</extracomment>
        <translation>本可承受 %1</translation>
    </message>
    <message>
        <source>May crack</source>
        <translation>可能开裂</translation>
    </message>
    <message>
        <source>Barely strong enough</source>
        <translation>勉强够结实</translation>
    </message>
    <message>
        <source>May crack under %1</source>
        <extracomment>%1 is a mass or a force</extracomment>
        <translation>承受 %1 可能开裂</translation>
    </message>
    <message>
        <source>Barely holds %1</source>
        <translation>勉强承受 %1</translation>
    </message>
    <message>
        <source>Will break</source>
        <translation>会断裂</translation>
    </message>
    <message>
        <source>Too weak</source>
        <translation>不够结实</translation>
    </message>
    <message>
        <source>Breaks under %1</source>
        <extracomment>%1 is a mass or a force</extracomment>
        <translation>承受 %1 会断裂</translation>
    </message>
    <message>
        <source>Too weak for %1</source>
        <translation>承受 %1 不够结实</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <extracomment>a verdict such as &quot;Holds 350 g&quot; and sentences about it</extracomment>
        <translation>%1。%2</translation>
    </message>
    <message>
        <source>%1 breaks %2 from %3.</source>
        <extracomment>%1 is a section, %2 a place such as &quot;beside its slit for Body&quot;, %3 a mass</extracomment>
        <translation>%1 从 %3 起会在%2断裂。</translation>
    </message>
    <message>
        <source>%1 may crack %2 from %3;</source>
        <extracomment>%1 is a section, %2 a place such as &quot;beside its slit for Body&quot;, %3 a mass</extracomment>
        <translation>%1 从 %3 起可能在%2开裂；</translation>
    </message>
    <message>
        <source>its neck breaks at %1.</source>
        <extracomment>the section that was just named; %1 is a mass</extracomment>
        <translation>其最窄处在 %1 时断裂。</translation>
    </message>
    <message>
        <source>the neck of %1 breaks at %2.</source>
        <extracomment>%1 is a section, %2 a mass</extracomment>
        <translation>%1 的最窄处在 %2 时断裂。</translation>
    </message>
    <message>
        <source>%1 may crack %2 from %3.</source>
        <translation>%1 从 %3 起可能在%2开裂。</translation>
    </message>
    <message>
        <source>With %1 a joint is pulled open.</source>
        <translation>达到 %1 时会有接头被拉开。</translation>
    </message>
    <message>
        <source>With %1 it no longer stands.</source>
        <translation>达到 %1 时就站不稳了。</translation>
    </message>
    <message>
        <source>It would hold far more.</source>
        <translation>它能承受的远不止这些。</translation>
    </message>
    <message>
        <source>How much it would hold could not be worked out.</source>
        <translation>无法算出它能承受多少。</translation>
    </message>
    <message>
        <source>Nothing puts a strain on it.</source>
        <translation>没有东西让它受力。</translation>
    </message>
    <message>
        <source>Weakest is %1, %2: less than 1 % of its strength.</source>
        <extracomment>%1 is a section, %2 a place such as &quot;beside its slit for Body&quot;</extracomment>
        <translation>最弱的是 %1，%2：不到其强度的 1 %。</translation>
    </message>
    <message>
        <source>Weakest is %1, %2: %3 % of its strength.</source>
        <extracomment>%1 is a section, %2 a place such as &quot;beside its slit for Body&quot;, %3 a number of percent</extracomment>
        <translation>最弱的是 %1，%2：已达到其强度的 %3 %。</translation>
    </message>
    <message>
        <source>Bends %1.</source>
        <extracomment>%1 is a length</extracomment>
        <translation>弯曲 %1。</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <extracomment>%1 is such as &quot;Would hold 350 g&quot;, %2 such as &quot;if it held together&quot;</extracomment>
        <translation>%2，%1</translation>
    </message>
    <message>
        <source>The neck of %1 is strained to %2 % of its strength.</source>
        <extracomment>%1 is a section, %2 a number of percent</extracomment>
        <translation>%1 的最窄处受力达到其强度的 %2 %。</translation>
    </message>
    <message>
        <source>That leaves less than the safety factor of %1.</source>
        <extracomment>%1 is a number such as 2</extracomment>
        <translation>这达不到安全系数 %1。</translation>
    </message>
    <message>
        <source>Strength unknown. No strength is set for the stock of %1.</source>
        <translation>强度未知。%1 的材料没有设置强度。</translation>
    </message>
    <message>
        <source>Strength unknown. The forces between the sections could not be worked out.</source>
        <translation>强度未知。无法算出插片之间的力。</translation>
    </message>
    <message>
        <source>Strength unknown. The stress in %1 could not be worked out.</source>
        <translation>强度未知。无法算出 %1 中的应力。</translation>
    </message>
    <message>
        <source>Slides away. Its feet do not hold it against what pushes it: push less, or give it more weight.</source>
        <translation>会滑走。支脚顶不住推它的力：请推轻些，或给它加重。</translation>
    </message>
    <message>
        <source>Comes loose. Nothing keeps %1 in place: glue the joints, or add one more.</source>
        <translation>会松脱。没有东西让 %1 保持原位：请粘牢接头，或再加一个。</translation>
    </message>
    <message>
        <source>Folds. Fingers turn like hinges, and nothing else keeps %1 from turning: glue them, or join them to one more section.</source>
        <translation>会折倒。指接会像铰链一样转动，而没有别的东西阻止 %1 转动：请粘牢，或再与一个插片连接。</translation>
    </message>
    <message>
        <source>Off the material. A weight on %1 misses its material; the nearest place takes it.</source>
        <translation>不在材料上。%1 上有个重物落在没有材料的地方；由最近的位置承受。</translation>
    </message>
    <message>
        <source>Use thicker stock, make it wider there, or put less on it.</source>
        <translation>改用更厚的材料、把那里加宽，或少放些东西。</translation>
    </message>
    <message>
        <source>Strength unknown</source>
        <translation>强度未知</translation>
    </message>
    <message>
        <source>Comes loose</source>
        <translation>会松脱</translation>
    </message>
    <message>
        <source>Folds</source>
        <translation>会折倒</translation>
    </message>
    <message>
        <source>Off the material</source>
        <translation>不在材料上</translation>
    </message>
    <message>
        <source>Use stock %1 thick</source>
        <extracomment>%1 is the thickness, the least one that is sold and that holds</extracomment>
        <translation>改用 %1 厚的材料</translation>
    </message>
    <message>
        <source>Use thicker stock</source>
        <translation>改用更厚的材料</translation>
    </message>
    <message>
        <source>Enter its strength</source>
        <translation>填写它的强度</translation>
    </message>
    <message>
        <source>Falls apart. %1 is held together by less than can be cut.</source>
        <translation>会散架。%1 的相连部分窄得无法切割。</translation>
    </message>
    <message>
        <source>Too little material. %1 is only %2 wide at one place.</source>
        <translation>材料太少。%1 有一处只有 %2 宽。</translation>
    </message>
    <message>
        <source>Falls apart</source>
        <translation>会散架</translation>
    </message>
    <message>
        <source>Make it wider there, or move apart what touches it.</source>
        <translation>把那里加宽，或把相碰的地方移开。</translation>
    </message>
    <message>
        <source>Too little material</source>
        <translation>材料太少</translation>
    </message>
    <message>
        <source>Make it wider there.</source>
        <translation>把那里加宽。</translation>
    </message>
    <message>
        <source>%1: its slits for %2 run into each other.</source>
        <translation>%1：接 %2 的插槽互相切通了。</translation>
    </message>
    <message>
        <source>%1: nothing is left between its slits for %2.</source>
        <translation>%1：接 %2 的插槽之间什么都不剩。</translation>
    </message>
    <message>
        <source>%1: nothing is left between its slit for %2 and a hole.</source>
        <translation>%1：接 %2 的插槽与孔之间什么都不剩。</translation>
    </message>
    <message>
        <source>%1: nothing is left between its slit for %2 and its edge.</source>
        <translation>%1：接 %2 的插槽与边缘之间什么都不剩。</translation>
    </message>
    <message>
        <source>%1: only %2 of material is left between its slits for %3.</source>
        <translation>%1：接 %3 的插槽之间只剩 %2 材料。</translation>
    </message>
    <message>
        <source>%1: only %2 of material is left between its slit for %3 and a hole.</source>
        <translation>%1：接 %3 的插槽与孔之间只剩 %2 材料。</translation>
    </message>
    <message>
        <source>%1: only %2 of material is left between its slit for %3 and its edge.</source>
        <translation>%1：接 %3 的插槽与边缘之间只剩 %2 材料。</translation>
    </message>
    <message>
        <source>Rather thin</source>
        <translation>有点薄弱</translation>
    </message>
    <message>
        <source>Make the section wider there, or move the slit.</source>
        <translation>把那里的插片加宽，或移动插槽。</translation>
    </message>
    <message>
        <source>Slits run into each other</source>
        <translation>插槽互相切通</translation>
    </message>
    <message>
        <source>Mass %1. The centre of mass lies %2 above the ground.</source>
        <translation>质量 %1。重心离地面 %2。</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>质量</translation>
    </message>
    <message>
        <source>%1 and %2 only touch: they overlap by less than %3.</source>
        <extracomment>%1 and %2 are names of sections, %3 is a length</extracomment>
        <translation>%1 和 %2 仅仅碰到：重叠不到 %3。</translation>
    </message>
    <message numerus="yes">
        <source>%n pairs of sections only touch: they overlap by less than %1.</source>
        <extracomment>%1 is a length</extracomment>
        <translation>
            <numerusform>%n 对插片仅仅碰到：重叠不到 %1。</numerusform>
        </translation>
    </message>
    <message>
        <source>Only touch</source>
        <translation>仅仅碰到</translation>
    </message>
    <message>
        <source>Turn %1 to 90°</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>把 %1 转到 90°</translation>
    </message>
    <message>
        <source>Slits cut a chip under 1 mm² off %1. It is waste and gets no number.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>插槽从 %1 上切下一块不到 1 mm² 的碎屑。它是废料，没有编号。</translation>
    </message>
    <message numerus="yes">
        <source>Slits cut %n chips under 1 mm² off %1. They are waste and get no number.</source>
        <extracomment>%1 names sections</extracomment>
        <translation>
            <numerusform>插槽从 %1 上切下 %n 块不到 1 mm² 的碎屑。它们是废料，没有编号。</numerusform>
        </translation>
    </message>
    <message>
        <source>Waste</source>
        <translation>废料</translation>
    </message>
    <message>
        <source>The slits of %1 divide it into %2, which other sections hold together.</source>
        <translation>%1 的插槽把它分成 %2，由其他插片固定在一起。</translation>
    </message>
    <message numerus="yes">
        <source>%n parts</source>
        <translation>
            <numerusform>%n 个零件</numerusform>
        </translation>
    </message>
    <message>
        <source>The slits of %1 leave nothing of it.</source>
        <translation>插槽把 %1 切得什么都不剩。</translation>
    </message>
    <message>
        <source>%1 could not be cut out: what its slits leave of it could not be worked out. Nothing can be exported; its mass counts without slits.</source>
        <translation>无法切出 %1：算不出开完插槽后还剩什么。目前什么都不能导出；它的质量按没有插槽计算。</translation>
    </message>
    <message>
        <source>%1 could not be worked out: sections of it are missing. Nothing can be exported.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>无法算出 %1：缺少它的插片。目前什么都不能导出。</translation>
    </message>
    <message>
        <source>Divided by slits</source>
        <translation>被插槽切断</translation>
    </message>
    <message>
        <source>Nothing left</source>
        <translation>什么都不剩</translation>
    </message>
    <message>
        <source>Not cut out</source>
        <translation>未切出</translation>
    </message>
    <message>
        <source>Operation failed</source>
        <translation>操作失败</translation>
    </message>
    <message>
        <source>Make it wider there</source>
        <translation>把那里加宽</translation>
    </message>
    <message numerus="yes">
        <source>%n sections moved</source>
        <translation>
            <numerusform>移动 %n 个插片</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sections moved down by %1</source>
        <extracomment>%1 is a length</extracomment>
        <translation>
            <numerusform>把 %n 个插片下移 %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sections moved up by %1</source>
        <translation>
            <numerusform>把 %n 个插片上移 %1</numerusform>
        </translation>
    </message>
    <message>
        <source>1 joint flipped</source>
        <translation>翻转 1 个接头</translation>
    </message>
    <message numerus="yes">
        <source>%n joints flipped</source>
        <translation>
            <numerusform>翻转 %n 个接头</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 becomes %2 thick</source>
        <extracomment>%1 is the name of a stock, %2 a length</extracomment>
        <translation>%1 变为 %2 厚</translation>
    </message>
    <message>
        <source>The slits of 1 joint meet elsewhere</source>
        <translation>1 个接头的插槽改在别处相接</translation>
    </message>
    <message numerus="yes">
        <source>The slits of %n joints meet elsewhere</source>
        <translation>
            <numerusform>%n 个接头的插槽改在别处相接</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 moved by %2</source>
        <extracomment>%1 is the name of a section, %2 a length</extracomment>
        <translation>把 %1 移动 %2</translation>
    </message>
    <message>
        <source>%1 turned by %2</source>
        <extracomment>%1 is the name of a section, %2 an angle</extracomment>
        <translation>把 %1 转动 %2</translation>
    </message>
    <message numerus="yes">
        <source>%n sections turned</source>
        <translation>
            <numerusform>转动 %n 个插片</numerusform>
        </translation>
    </message>
    <message>
        <source>a new joint with a slit of %1</source>
        <extracomment>%1 is a length</extracomment>
        <translation>新增一个插槽为 %1 的接头</translation>
    </message>
    <message>
        <source>1 new joint</source>
        <translation>新增 1 个接头</translation>
    </message>
    <message numerus="yes">
        <source>%n new joints</source>
        <translation>
            <numerusform>新增 %n 个接头</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 reshaped</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>改变 %1 的形状</translation>
    </message>
    <message numerus="yes">
        <source>%n sections reshaped</source>
        <translation>
            <numerusform>改变 %n 个插片的形状</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 added</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>添加 %1</translation>
    </message>
    <message numerus="yes">
        <source>%n sections added</source>
        <translation>
            <numerusform>添加 %n 个插片</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 deleted</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>删除 %1</translation>
    </message>
    <message numerus="yes">
        <source>%n sections deleted</source>
        <translation>
            <numerusform>删除 %n 个插片</numerusform>
        </translation>
    </message>
    <message>
        <source>nothing more is cut through</source>
        <translation>不会再切断别处</translation>
    </message>
    <message>
        <source>1 problem solved</source>
        <translation>解决 1 个问题</translation>
    </message>
    <message numerus="yes">
        <source>%n problems solved</source>
        <translation>
            <numerusform>解决 %n 个问题</numerusform>
        </translation>
    </message>
    <message>
        <source>then: %1</source>
        <extracomment>after other things that change; %1 is a verdict such as &quot;Holds 350 g&quot;</extracomment>
        <translation>之后：%1</translation>
    </message>
    <message>
        <source>new: %1</source>
        <extracomment>after other things that change; %1 is a verdict such as &quot;Too little material&quot;</extracomment>
        <translation>新出现：%1</translation>
    </message>
    <message numerus="yes">
        <source>%n new remarks</source>
        <translation>
            <numerusform>%n 条新提示</numerusform>
        </translation>
    </message>
    <message>
        <source>beside its slit for %1</source>
        <extracomment>where a part may break; %1 is the name of a section</extracomment>
        <translation>接 %1 的插槽旁</translation>
    </message>
    <message>
        <source>where it joins %1</source>
        <extracomment>where a part may break; %1 is the name of a section</extracomment>
        <translation>与 %1 的相接处</translation>
    </message>
    <message>
        <source>at an inner corner</source>
        <extracomment>where a part may break</extracomment>
        <translation>内角处</translation>
    </message>
    <message>
        <source>at its neck</source>
        <extracomment>where a part may break</extracomment>
        <translation>最窄处</translation>
    </message>
    <message numerus="yes">
        <source>%n sections</source>
        <translation>
            <numerusform>%n 个插片</numerusform>
        </translation>
    </message>
    <message>
        <source>%1&#x202f;N</source>
        <translation>%1&#x202f;N</translation>
    </message>
    <message>
        <source>Joined in rings</source>
        <translation>连成几圈</translation>
    </message>
    <message>
        <source>In the ground. %1 reaches %2 below it.</source>
        <translation>陷入地面。%1 伸到了地面以下 %2。</translation>
    </message>
    <message>
        <source>In the ground. %1 reach up to %2 below it.</source>
        <translation>陷入地面。%1 伸到了地面以下，最深 %2。</translation>
    </message>
    <message>
        <source>In the ground</source>
        <translation>陷入地面</translation>
    </message>
    <message>
        <source>Shift the planes by %1 %</source>
        <extracomment>of the slices of a mesh; %1 is a number, a part of the distance between two of them</extracomment>
        <translation>平面偏移 %1 %</translation>
    </message>
    <message>
        <source>One plane more each way</source>
        <translation>每个方向多一个平面</translation>
    </message>
    <message>
        <source>Fits the sheets and offcuts that there are.</source>
        <translation>可以放在现有的板材和余料上。</translation>
    </message>
    <message numerus="yes">
        <source>At most %n sheets</source>
        <extracomment>in the middle of a sentence that begins with something else</extracomment>
        <translation>
            <numerusform>最多 %n 张板材</numerusform>
        </translation>
    </message>
    <message>
        <source>Fits the sheet. %1.</source>
        <translation>板材放得下。%1。</translation>
    </message>
    <message>
        <source>Fits the sheet. %1 of %2.</source>
        <translation>板材放得下。%1（%2）。</translation>
    </message>
    <message>
        <source>Sections overlap slightly</source>
        <translation>插片略有重叠</translation>
    </message>
    <message numerus="yes">
        <source>May run out of sheets. It takes up to %n sheets of %1, and you have %2.</source>
        <extracomment>%n is a number of sheets, two at least; %1 is a stock, %2 how many sheets there are of it</extracomment>
        <translation>
            <numerusform>板材可能不够。最多需要 %n 张 %1 板材，现有 %2 张。</numerusform>
        </translation>
    </message>
    <message>
        <source>May run out of sheets</source>
        <translation>板材可能不够</translation>
    </message>
    <message>
        <source>Look in Sheets how closely the parts can lie.</source>
        <translation>可在“板材”中查看零件能排得多紧。</translation>
    </message>
    <message>
        <source>Planes every %1</source>
        <extracomment>of the slices of a mesh; %1 is a length</extracomment>
        <translation>每 %1 一个平面</translation>
    </message>
    <message>
        <source>%1, shifted by %2 %</source>
        <extracomment>of the slices of a mesh; %1 is such as &quot;One plane fewer each way&quot;</extracomment>
        <translation>%1，偏移 %2 %</translation>
    </message>
    <message>
        <source>One plane more</source>
        <translation>多一个平面</translation>
    </message>
    <message>
        <source>One plane fewer each way</source>
        <translation>每个方向少一个平面</translation>
    </message>
    <message>
        <source>One plane fewer</source>
        <translation>少一个平面</translation>
    </message>
    <message>
        <source>Two planes more each way</source>
        <translation>每个方向多两个平面</translation>
    </message>
    <message>
        <source>Two planes more</source>
        <translation>多两个平面</translation>
    </message>
    <message>
        <source>Two planes fewer each way</source>
        <translation>每个方向少两个平面</translation>
    </message>
    <message>
        <source>Two planes fewer</source>
        <translation>少两个平面</translation>
    </message>
    <message>
        <source>None of the shifts and numbers of planes that were tried lets them slide together. Bake the slices and shorten one of them, or leave it out.</source>
        <translation>试过的偏移和平面数都不能让它们插在一起。请把切片定型，然后缩短其中一个，或去掉它。</translation>
    </message>
</context>
<context>
    <name>Command</name>
    <message>
        <source>The model is here to be adjusted; “Edit the design” brings all back</source>
        <translation>这个模型供调整使用；“编辑设计”可恢复全部功能</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>打开…</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>Open a model, also from FlatFab</source>
        <translation>打开一个模型，也可以是 FlatFab 的</translation>
    </message>
    <message>
        <source>&amp;Insert model…</source>
        <translation>插入模型…</translation>
    </message>
    <message>
        <source>Insert</source>
        <translation>插入</translation>
    </message>
    <message>
        <source>Add the sections of another model to this one</source>
        <translation>把另一个模型的插片加到这个模型中</translation>
    </message>
    <message>
        <source>Te&amp;mplate to draw over…</source>
        <translation>用于描画的参考物…</translation>
    </message>
    <message>
        <source>Template</source>
        <translation>参考物</translation>
    </message>
    <message>
        <source>Read a mesh, a picture or a drawing to draw sections over</source>
        <translation>读入网格、图片或图稿，在上面描画插片</translation>
    </message>
    <message>
        <source>Add to the &amp;library</source>
        <translation>加入零件库</translation>
    </message>
    <message>
        <source>To library</source>
        <translation>入库</translation>
    </message>
    <message>
        <source>Keep the selection in the library, for other models</source>
        <translation>把所选内容存入零件库，供其他模型使用</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Save the model</source>
        <translation>保存模型</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>另存为…</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>另存为</translation>
    </message>
    <message>
        <source>Save the model under another name</source>
        <translation>用另一个名称保存模型</translation>
    </message>
    <message>
        <source>&amp;Export cutting files…</source>
        <translation>导出切割文件…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>导出…</translation>
    </message>
    <message>
        <source>Write the parts to a file for the laser cutter</source>
        <translation>把零件写成激光切割机用的文件</translation>
    </message>
    <message>
        <source>Export a&amp;gain</source>
        <translation>再次导出</translation>
    </message>
    <message>
        <source>Export again</source>
        <translation>再次导出</translation>
    </message>
    <message>
        <source>Write the same file again, with the same choices</source>
        <translation>用同样的选项再写一次同一个文件</translation>
    </message>
    <message>
        <source>Re&amp;vert to saved</source>
        <translation>恢复到已保存版本</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>恢复</translation>
    </message>
    <message>
        <source>Go back to the model as it is in its file; Undo brings the changes back</source>
        <translation>回到文件中保存的模型；撤销可找回改动</translation>
    </message>
    <message>
        <source>Se&amp;ttings…</source>
        <translation>设置…</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>设置</translation>
    </message>
    <message>
        <source>Units, colours, language, files and shortcuts</source>
        <translation>单位、颜色、语言、文件和快捷键</translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts…</source>
        <translation>键盘快捷键…</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>快捷键</translation>
    </message>
    <message>
        <source>See which keys do what, and choose your own</source>
        <translation>看看哪个键做什么，也可自己设定</translation>
    </message>
    <message>
        <source>&amp;Close window</source>
        <translation>关闭窗口</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Close this window; others stay open</source>
        <translation>关闭这个窗口；其他窗口保持打开</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>退出</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>退出</translation>
    </message>
    <message>
        <source>Close all windows and the program</source>
        <translation>关闭所有窗口并退出程序</translation>
    </message>
    <message>
        <source>Go to Properties</source>
        <translation>转到属性</translation>
    </message>
    <message>
        <source>Properties</source>
        <translation>属性</translation>
    </message>
    <message>
        <source>Go to the first field of the selection; in the view, Enter does the same</source>
        <translation>转到所选内容的第一个输入框；在视图中按 Enter 也一样</translation>
    </message>
    <message>
        <source>Hide all panels</source>
        <translation>隐藏所有面板</translation>
    </message>
    <message>
        <source>Hide panels</source>
        <translation>隐藏面板</translation>
    </message>
    <message>
        <source>Hide or show the panels at the sides</source>
        <translation>隐藏或显示两侧的面板</translation>
    </message>
    <message>
        <source>F&amp;ull screen</source>
        <translation>全屏</translation>
    </message>
    <message>
        <source>Full screen</source>
        <translation>全屏</translation>
    </message>
    <message>
        <source>Fill the screen with the window</source>
        <translation>让窗口占满屏幕</translation>
    </message>
    <message>
        <source>Reset &amp;window</source>
        <translation>重置窗口</translation>
    </message>
    <message>
        <source>Reset window</source>
        <translation>重置窗口</translation>
    </message>
    <message>
        <source>Put all panels back in their original places</source>
        <translation>把所有面板放回原来的位置</translation>
    </message>
    <message>
        <source>&amp;Next part of the window</source>
        <translation>窗口的下一部分</translation>
    </message>
    <message>
        <source>Next part</source>
        <translation>下一部分</translation>
    </message>
    <message>
        <source>Go to the next part of the window: tool bar, left, view, right</source>
        <translation>转到窗口的下一部分：工具栏、左侧、视图、右侧</translation>
    </message>
    <message>
        <source>Previous part of the win&amp;dow</source>
        <translation>窗口的上一部分</translation>
    </message>
    <message>
        <source>Previous part</source>
        <translation>上一部分</translation>
    </message>
    <message>
        <source>Go back to the part of the window before this one</source>
        <translation>回到窗口的上一部分</translation>
    </message>
    <message>
        <source>&amp;Next problem</source>
        <translation>下一个问题</translation>
    </message>
    <message>
        <source>Next problem</source>
        <translation>下一个问题</translation>
    </message>
    <message>
        <source>Select the sections of the next problem and show them</source>
        <translation>选中并显示下一个问题涉及的插片</translation>
    </message>
    <message>
        <source>&amp;Previous problem</source>
        <translation>上一个问题</translation>
    </message>
    <message>
        <source>Previous problem</source>
        <translation>上一个问题</translation>
    </message>
    <message>
        <source>Select the sections of the problem before this one</source>
        <translation>选中上一个问题涉及的插片</translation>
    </message>
    <message>
        <source>Show the &amp;steps</source>
        <translation>显示步骤</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>步骤</translation>
    </message>
    <message>
        <source>Show step by step how the model is put together</source>
        <translation>一步一步显示模型怎样拼装</translation>
    </message>
    <message>
        <source>Stoc&amp;ks…</source>
        <translation>材料…</translation>
    </message>
    <message>
        <source>Stocks</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>Sheet materials: thickness, strength, kerf and sheet size</source>
        <translation>板材的材料：厚度、强度、切缝和板材尺寸</translation>
    </message>
    <message>
        <source>&amp;Fit coupon…</source>
        <translation>试片…</translation>
    </message>
    <message>
        <source>Fit coupon</source>
        <translation>试片</translation>
    </message>
    <message>
        <source>Write a test piece that tells which slits fit and how wide the machine cuts</source>
        <translation>写出一个试片文件，用来看哪个插槽合适、机器切缝有多宽</translation>
    </message>
    <message>
        <source>S&amp;heets</source>
        <translation>板材</translation>
    </message>
    <message>
        <source>Sheets</source>
        <translation>板材</translation>
    </message>
    <message>
        <source>Show the parts on their sheets, as they will be cut</source>
        <translation>显示零件在板材上的排版，切割出来就是这样</translation>
    </message>
    <message>
        <source>Go to the values</source>
        <translation>转到参数</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>Adjust the values that numbers of the model are made of</source>
        <translation>调整构成模型数字的参数</translation>
    </message>
    <message>
        <source>New value</source>
        <translation>新建参数</translation>
    </message>
    <message>
        <source>A number with a name, which number fields take</source>
        <translation>带名称的数字，可用在数字输入框中</translation>
    </message>
    <message>
        <source>&amp;Find a command…</source>
        <translation>查找命令…</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>查找</translation>
    </message>
    <message>
        <source>Type to find anything that the program can do</source>
        <translation>输入文字，查找程序能做的任何事</translation>
    </message>
    <message>
        <source>First ste&amp;ps</source>
        <translation>入门</translation>
    </message>
    <message>
        <source>First steps</source>
        <translation>入门</translation>
    </message>
    <message>
        <source>How a model is made, step by step, with pictures</source>
        <translation>怎样做一个模型，一步一步，带图</translation>
    </message>
    <message>
        <source>&amp;Start page</source>
        <translation>起始页</translation>
    </message>
    <message>
        <source>Start page</source>
        <translation>起始页</translation>
    </message>
    <message>
        <source>Recent models and samples</source>
        <translation>最近的模型和示例</translation>
    </message>
    <message>
        <source>&amp;About FlatFitFab</source>
        <translation>关于 FlatFitFab</translation>
    </message>
    <message>
        <source>About</source>
        <translation>关于</translation>
    </message>
    <message>
        <source>What this program is, its version and its licences</source>
        <translation>这个程序是什么，它的版本和许可证</translation>
    </message>
    <message>
        <source>It has not been exported yet</source>
        <translation>还没有导出过</translation>
    </message>
    <message>
        <source>It has never been saved</source>
        <translation>还没有保存过</translation>
    </message>
    <message>
        <source>Nothing has changed since it was saved</source>
        <translation>保存之后没有任何改动</translation>
    </message>
    <message>
        <source>Stren&amp;gth map</source>
        <translation>强度图</translation>
    </message>
    <message>
        <source>Strength map</source>
        <translation>强度图</translation>
    </message>
    <message>
        <source>Colour a section by the mass that each place of it can hold</source>
        <translation>按各处能承受的质量给插片上色</translation>
    </message>
    <message>
        <source>Select the section to look at first</source>
        <translation>请先选中要查看的插片</translation>
    </message>
    <message>
        <source>Select one section first</source>
        <translation>请先选中一个插片</translation>
    </message>
    <message>
        <source>No joint is selected: select a section, then one of its joints</source>
        <translation>没有选中接头：先选中一个插片，再选它的一个接头</translation>
    </message>
    <message>
        <source>There is no other section</source>
        <translation>没有别的插片</translation>
    </message>
    <message>
        <source>No operation is selected</source>
        <translation>没有选中操作</translation>
    </message>
    <message>
        <source>There is no section yet</source>
        <translation>还没有插片</translation>
    </message>
    <message>
        <source>No section is selected</source>
        <translation>没有选中插片</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>剪切</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>剪切</translation>
    </message>
    <message>
        <source>Copy the selected sections and delete them</source>
        <translation>复制选中的插片，然后删除它们</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>Copy the selected sections, also for other windows and programs</source>
        <translation>复制选中的插片，也可用于其他窗口和程序</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>粘贴</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>粘贴</translation>
    </message>
    <message>
        <source>Add the sections that were copied, or a picture to draw over</source>
        <translation>添加复制的插片，或用于描画的图片</translation>
    </message>
    <message>
        <source>Dup&amp;licate</source>
        <translation>创建副本</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>创建副本</translation>
    </message>
    <message>
        <source>Put a copy of the selected sections beside them</source>
        <translation>在旁边放一份选中插片的副本</translation>
    </message>
    <message>
        <source>Across &amp;X</source>
        <translation>X 方向</translation>
    </message>
    <message>
        <source>Mirror X</source>
        <translation>X 镜像</translation>
    </message>
    <message>
        <source>Put a mirror image of the selected sections on the other side of the plane where X is 0</source>
        <translation>以 X 为 0 的平面为镜面，在另一侧放一份选中插片的镜像</translation>
    </message>
    <message>
        <source>Across &amp;Y</source>
        <translation>Y 方向</translation>
    </message>
    <message>
        <source>Mirror Y</source>
        <translation>Y 镜像</translation>
    </message>
    <message>
        <source>Put a mirror image of the selected sections on the other side of the plane where Y is 0</source>
        <translation>以 Y 为 0 的平面为镜面，在另一侧放一份选中插片的镜像</translation>
    </message>
    <message>
        <source>Across &amp;Z</source>
        <translation>Z 方向</translation>
    </message>
    <message>
        <source>Mirror Z</source>
        <translation>Z 镜像</translation>
    </message>
    <message>
        <source>Put a mirror image of the selected sections on the other side of the plane where Z is 0</source>
        <translation>以 Z 为 0 的平面为镜面，在另一侧放一份选中插片的镜像</translation>
    </message>
    <message>
        <source>Across a &amp;section…</source>
        <translation>以插片为镜面…</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>镜像</translation>
    </message>
    <message>
        <source>Click a section: a mirror image of the selected ones comes on its other side</source>
        <translation>点击一个插片：选中插片的镜像会出现在它的另一侧</translation>
    </message>
    <message>
        <source>Sections from SV&amp;G…</source>
        <translation>从 SVG 生成插片…</translation>
    </message>
    <message>
        <source>From SVG</source>
        <translation>SVG 插片</translation>
    </message>
    <message>
        <source>A section for every outline of a drawing</source>
        <translation>图稿中每条轮廓线生成一个插片</translation>
    </message>
    <message>
        <source>&amp;Contour from SVG…</source>
        <translation>从 SVG 生成轮廓…</translation>
    </message>
    <message>
        <source>Contour from SVG</source>
        <translation>SVG 轮廓</translation>
    </message>
    <message>
        <source>The largest outline of a drawing in place of the selected section&apos;s</source>
        <translation>用图稿中最大的轮廓线替换选中插片的轮廓</translation>
    </message>
    <message>
        <source>&amp;Holes from SVG…</source>
        <translation>从 SVG 生成孔…</translation>
    </message>
    <message>
        <source>Holes from SVG</source>
        <translation>SVG 孔</translation>
    </message>
    <message>
        <source>A hole of the selected section for every outline of a drawing</source>
        <translation>图稿中每条轮廓线在选中的插片上开一个孔</translation>
    </message>
    <message>
        <source>&amp;Marks from SVG…</source>
        <translation>从 SVG 生成标记…</translation>
    </message>
    <message>
        <source>Marks from SVG</source>
        <translation>SVG 标记</translation>
    </message>
    <message>
        <source>The lines of a drawing, engraved or scored on the selected section</source>
        <translation>把图稿的线条雕刻或刻线到选中的插片上</translation>
    </message>
    <message>
        <source>&amp;Draw a shape</source>
        <translation>画形状</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>形状</translation>
    </message>
    <message>
        <source>Drag a circle, rectangle or the like out of its middle</source>
        <translation>从中心向外拖出圆、矩形等形状</translation>
    </message>
    <message>
        <source>&amp;Circle</source>
        <translation>圆</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>圆</translation>
    </message>
    <message>
        <source>By numbers: a hole in the selected section, or a section of its own</source>
        <translation>按数字绘制：在选中的插片上开孔，或单独成为插片</translation>
    </message>
    <message>
        <source>&amp;Ellipse</source>
        <translation>椭圆</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>椭圆</translation>
    </message>
    <message>
        <source>&amp;Rectangle</source>
        <translation>矩形</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>矩形</translation>
    </message>
    <message>
        <source>&amp;Polygon</source>
        <translation>多边形</translation>
    </message>
    <message>
        <source>Polygon</source>
        <translation>多边形</translation>
    </message>
    <message>
        <source>&amp;Star</source>
        <translation>星形</translation>
    </message>
    <message>
        <source>Star</source>
        <translation>星形</translation>
    </message>
    <message>
        <source>S&amp;lot</source>
        <translation>长圆形</translation>
    </message>
    <message>
        <source>Slot</source>
        <translation>长圆形</translation>
    </message>
    <message>
        <source>Move a te&amp;mplate</source>
        <translation>移动参考物</translation>
    </message>
    <message>
        <source>Handles</source>
        <translation>手柄</translation>
    </message>
    <message>
        <source>Move, turn and scale the template with handles or numbers</source>
        <translation>用手柄或数字移动、转动和缩放参考物</translation>
    </message>
    <message>
        <source>Size a template by a &amp;line</source>
        <translation>按线缩放参考物</translation>
    </message>
    <message>
        <source>Size by a line</source>
        <translation>按线缩放</translation>
    </message>
    <message>
        <source>Draw a line over the template and say how long it is</source>
        <translation>在参考物上画一条线，再说明它有多长</translation>
    </message>
    <message>
        <source>There is no picture and no drawing: add one first</source>
        <translation>没有图片或图稿：请先添加一个</translation>
    </message>
    <message>
        <source>There is no template: add a mesh or a picture first</source>
        <translation>没有参考物：请先添加网格或图片</translation>
    </message>
    <message>
        <source>Flip the slits of the &amp;joint</source>
        <translation>翻转接头的插槽</translation>
    </message>
    <message>
        <source>Flip the slits</source>
        <translation>翻转插槽</translation>
    </message>
    <message>
        <source>Let the slits of the selected joint open to the other side</source>
        <translation>让选中接头的插槽朝另一侧开口</translation>
    </message>
    <message>
        <source>Restore a&amp;utomatic settings</source>
        <translation>恢复自动设置</translation>
    </message>
    <message>
        <source>Restore automatic</source>
        <translation>恢复自动</translation>
    </message>
    <message>
        <source>Let the program choose kind, direction and meeting points of the selected joint again</source>
        <translation>重新让程序决定选中接头的类型、方向和相接点</translation>
    </message>
    <message>
        <source>Nothing of this joint is set by hand</source>
        <translation>这个接头没有手动设置</translation>
    </message>
    <message>
        <source>Add &amp;weight</source>
        <translation>添加重物</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>重物</translation>
    </message>
    <message>
        <source>Put a weight on a section to see what it can hold</source>
        <translation>在插片上放一个重物，看它能承受多少</translation>
    </message>
    <message>
        <source>Add p&amp;ush</source>
        <translation>添加推力</translation>
    </message>
    <message>
        <source>Push</source>
        <translation>推力</translation>
    </message>
    <message>
        <source>Push or pull a section in one place to see what it can hold</source>
        <translation>在插片的某处推或拉，看它能承受多少</translation>
    </message>
    <message>
        <source>Pull &amp;here</source>
        <translation>在这里拉</translation>
    </message>
    <message>
        <source>Pull</source>
        <translation>拉</translation>
    </message>
    <message>
        <source>Pull a section with the mouse to see what happens; nothing is kept</source>
        <translation>用鼠标拉一个插片，看会发生什么；结果不保留</translation>
    </message>
    <message>
        <source>Nothing acts on the model: add a weight or a push first</source>
        <translation>模型没有受力：请先添加重物或推力</translation>
    </message>
    <message>
        <source>There is no mesh that could be pulled</source>
        <translation>没有可磁吸的网格</translation>
    </message>
    <message>
        <source>Add te&amp;xt or lines to engrave</source>
        <translation>添加要雕刻的文字或线条</translation>
    </message>
    <message>
        <source>Engrave</source>
        <translation>雕刻</translation>
    </message>
    <message>
        <source>Write or draw on a section, to be engraved or scored</source>
        <translation>在插片上写字或画线，用于雕刻或刻线</translation>
    </message>
    <message>
        <source>&amp;Engrave</source>
        <translation>雕刻</translation>
    </message>
    <message>
        <source>What is drawn next is engraved</source>
        <translation>接下来画的内容用于雕刻</translation>
    </message>
    <message>
        <source>&amp;Score</source>
        <translation>刻线</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>刻线</translation>
    </message>
    <message>
        <source>What is drawn next is scored, to fold or break along</source>
        <translation>接下来画的内容用于刻线，便于折叠或掰断</translation>
    </message>
    <message>
        <source>M&amp;easure</source>
        <translation>测量</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>测量</translation>
    </message>
    <message>
        <source>Measure between two places; keep the length, or scale the model to it</source>
        <translation>测量两处之间的距离；可保留这个长度，或按它缩放模型</translation>
    </message>
    <message>
        <source>Scale to a &amp;length</source>
        <translation>按长度缩放</translation>
    </message>
    <message>
        <source>Scale to a length</source>
        <translation>按长度缩放</translation>
    </message>
    <message>
        <source>Set a length and scale the model to match</source>
        <translation>设定一个长度，模型随之缩放</translation>
    </message>
    <message>
        <source>Keep t&amp;he length</source>
        <translation>保留长度</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>保留</translation>
    </message>
    <message>
        <source>Keep showing this length</source>
        <translation>一直显示这个长度</translation>
    </message>
    <message>
        <source>Rem&amp;ove this dimension</source>
        <translation>移除这个尺寸</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Remove this dimension</source>
        <translation>移除这个尺寸</translation>
    </message>
    <message>
        <source>Nothing is measured</source>
        <translation>没有测量任何东西</translation>
    </message>
    <message>
        <source>No dimension is picked: click one with Measure</source>
        <translation>没有选中尺寸：请用“测量”点击一个</translation>
    </message>
    <message>
        <source>&amp;Mirror…</source>
        <translation>镜像…</translation>
    </message>
    <message>
        <source>Mirror the selected sections, or one side of the model to the other</source>
        <translation>镜像选中的插片，或把模型的一侧镜像到另一侧</translation>
    </message>
    <message>
        <source>Mirror left and right (X)</source>
        <translation>左右镜像（X）</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Mirror across the plane where X is 0</source>
        <translation>以 X 为 0 的平面为镜面</translation>
    </message>
    <message>
        <source>Mirror up and down (Y)</source>
        <translation>上下镜像（Y）</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Mirror across the plane where Y is 0</source>
        <translation>以 Y 为 0 的平面为镜面</translation>
    </message>
    <message>
        <source>Mirror front and back (Z)</source>
        <translation>前后镜像（Z）</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>Mirror across the plane where Z is 0</source>
        <translation>以 Z 为 0 的平面为镜面</translation>
    </message>
    <message>
        <source>Mirror across a section</source>
        <translation>以插片为镜面</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>插片</translation>
    </message>
    <message>
        <source>Mirror across the plane of the section that is clicked</source>
        <translation>以点击的插片所在平面为镜面</translation>
    </message>
    <message>
        <source>Mirror a copy of the selection</source>
        <translation>镜像所选的副本</translation>
    </message>
    <message>
        <source>Add a mirror image of the selected sections</source>
        <translation>添加选中插片的镜像</translation>
    </message>
    <message>
        <source>Keep both sides the same</source>
        <translation>保持两侧相同</translation>
    </message>
    <message>
        <source>Both sides</source>
        <translation>两侧</translation>
    </message>
    <message>
        <source>Mirror everything drawn on one side, now and later</source>
        <translation>镜像画在一侧的所有内容，现在和以后都一样</translation>
    </message>
    <message>
        <source>Make symmetric once</source>
        <translation>变对称一次</translation>
    </message>
    <message>
        <source>Once</source>
        <translation>一次</translation>
    </message>
    <message>
        <source>Copy one side to the other; later edits are not copied</source>
        <translation>把一侧复制到另一侧；之后的改动不再复制</translation>
    </message>
    <message>
        <source>Mirror as shown</source>
        <translation>按所示镜像</translation>
    </message>
    <message>
        <source>Do what is shown</source>
        <translation>按显示的样子执行</translation>
    </message>
    <message>
        <source>Choose Mirror first</source>
        <translation>请先选择“镜像”</translation>
    </message>
    <message>
        <source>Ta&amp;ke the offered shape</source>
        <translation>采用建议的形状</translation>
    </message>
    <message>
        <source>Offered shape</source>
        <translation>采用建议</translation>
    </message>
    <message>
        <source>Turn what was just drawn into the offered circle, ellipse, straight lines or right angles, or move its slit in from the edge</source>
        <translation>把刚画的内容变成建议的圆、椭圆、直线或直角，或把它的插槽从边缘往里移</translation>
    </message>
    <message>
        <source>&amp;Take the whole guide</source>
        <translation>采用整条引导线</translation>
    </message>
    <message>
        <source>Take the guide</source>
        <translation>采用引导线</translation>
    </message>
    <message>
        <source>Make the section of all that its plane cuts of a template, with its holes</source>
        <translation>用插片平面截取参考物得到的全部形状生成插片，包括孔</translation>
    </message>
    <message>
        <source>Nothing is offered for what was just drawn</source>
        <translation>对刚画的内容没有建议</translation>
    </message>
    <message>
        <source>The plane that is drawn on cuts no template</source>
        <translation>绘图平面没有截到参考物</translation>
    </message>
    <message>
        <source>&amp;Linear</source>
        <translation>成排</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>成排</translation>
    </message>
    <message>
        <source>Repeat a section in a row along another one</source>
        <translation>沿另一个插片把一个插片重复排成一排</translation>
    </message>
    <message>
        <source>&amp;Revolve along contour</source>
        <translation>沿轮廓环绕</translation>
    </message>
    <message>
        <source>Revolve</source>
        <translation>环绕</translation>
    </message>
    <message>
        <source>Repeat a section round the contour of another one</source>
        <translation>绕着另一个插片的轮廓重复一个插片</translation>
    </message>
    <message>
        <source>&amp;Blend</source>
        <translation>过渡</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>过渡</translation>
    </message>
    <message>
        <source>Interpolate between sections</source>
        <translation>在插片之间插补出中间形状</translation>
    </message>
    <message>
        <source>Br&amp;anch</source>
        <translation>分枝</translation>
    </message>
    <message>
        <source>Branch</source>
        <translation>分枝</translation>
    </message>
    <message>
        <source>Grow copies of a section out of itself, like a tree</source>
        <translation>让插片从自身长出副本，像树一样</translation>
    </message>
    <message>
        <source>&amp;Grid with connectors</source>
        <translation>带连接件的分格</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>分格</translation>
    </message>
    <message>
        <source>Divide a section that is too large for the sheet</source>
        <translation>把大得板材放不下的插片分开</translation>
    </message>
    <message>
        <source>Ra&amp;dial contour</source>
        <translation>径向轮廓</translation>
    </message>
    <message>
        <source>Radial</source>
        <translation>径向</translation>
    </message>
    <message>
        <source>Turn a section into a circle, a star or a gear, or cut such holes into it</source>
        <translation>把插片变成圆、星形或齿轮，或开出这样的孔</translation>
    </message>
    <message>
        <source>&amp;Mirror model</source>
        <translation>镜像模型</translation>
    </message>
    <message>
        <source>Repeat everything drawn on one side on the other</source>
        <translation>画在一侧的所有内容，在另一侧重复</translation>
    </message>
    <message>
        <source>Ro&amp;tational symmetry</source>
        <translation>旋转对称</translation>
    </message>
    <message>
        <source>Rotational</source>
        <translation>旋转对称</translation>
    </message>
    <message>
        <source>Repeat everything drawn once all round an axis</source>
        <translation>把画过一次的所有内容绕轴重复一圈</translation>
    </message>
    <message>
        <source>Arra&amp;y</source>
        <translation>阵列</translation>
    </message>
    <message>
        <source>Array</source>
        <translation>阵列</translation>
    </message>
    <message>
        <source>Repeat sections along a line through space</source>
        <translation>沿空间中的一条直线重复插片</translation>
    </message>
    <message>
        <source>&amp;Slices of a mesh</source>
        <translation>网格的切片</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>切片</translation>
    </message>
    <message>
        <source>Cut a mesh that is drawn over into sections that follow it</source>
        <translation>把用来参照的网格切成贴合它的插片</translation>
    </message>
    <message>
        <source>Make symmetric &amp;now</source>
        <translation>立即变对称</translation>
    </message>
    <message>
        <source>Symmetric</source>
        <translation>对称</translation>
    </message>
    <message>
        <source>Mirror one side to the other, once</source>
        <translation>把一侧镜像到另一侧，只做一次</translation>
    </message>
    <message>
        <source>&amp;Switch off or on</source>
        <translation>关闭或启用</translation>
    </message>
    <message>
        <source>On</source>
        <translation>启用</translation>
    </message>
    <message>
        <source>Switch the selected operation off, or on again</source>
        <translation>关闭选中的操作，或重新启用</translation>
    </message>
    <message>
        <source>Earlier in the &amp;order</source>
        <translation>顺序提前</translation>
    </message>
    <message>
        <source>Earlier</source>
        <translation>提前</translation>
    </message>
    <message>
        <source>Run the selected operation before the one above it</source>
        <translation>让选中的操作在它上面那个之前执行</translation>
    </message>
    <message>
        <source>Lat&amp;er in the order</source>
        <translation>顺序推后</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>推后</translation>
    </message>
    <message>
        <source>Run the selected operation after the one below it</source>
        <translation>让选中的操作在它下面那个之后执行</translation>
    </message>
    <message>
        <source>Ba&amp;ke into sections</source>
        <translation>定型为插片</translation>
    </message>
    <message>
        <source>Bake</source>
        <translation>定型</translation>
    </message>
    <message>
        <source>Turn what the selected operation makes into drawn sections</source>
        <translation>把选中操作生成的内容变成手画的插片</translation>
    </message>
    <message>
        <source>There is no mesh to slice: add one first</source>
        <translation>没有可切片的网格：请先添加一个</translation>
    </message>
    <message>
        <source>It is the first one</source>
        <translation>它已经是第一个</translation>
    </message>
    <message>
        <source>It is the last one</source>
        <translation>它已经是最后一个</translation>
    </message>
    <message>
        <source>S&amp;nap</source>
        <translation>吸附</translation>
    </message>
    <message>
        <source>Snap</source>
        <translation>吸附</translation>
    </message>
    <message>
        <source>Snap to points, alignment lines and grid</source>
        <translation>吸附到点、对齐线和方格</translation>
    </message>
    <message>
        <source>P&amp;en</source>
        <translation>钢笔</translation>
    </message>
    <message>
        <source>Pen</source>
        <translation>钢笔</translation>
    </message>
    <message>
        <source>Draw with clicks instead of one stroke: set points, drag to bend</source>
        <translation>不用一笔画成，而是点击绘制：点击放点，拖动弯曲</translation>
    </message>
    <message>
        <source>No number is typed</source>
        <translation>没有输入数字</translation>
    </message>
    <message>
        <source>Re&amp;move holes</source>
        <translation>移除孔</translation>
    </message>
    <message>
        <source>No holes</source>
        <translation>去孔</translation>
    </message>
    <message>
        <source>Close all holes of the selected sections</source>
        <translation>填上选中插片的所有孔</translation>
    </message>
    <message>
        <source>&amp;Add point</source>
        <translation>添加点</translation>
    </message>
    <message>
        <source>Add point</source>
        <translation>添加点</translation>
    </message>
    <message>
        <source>Add a control point under the cursor, or beside the selected one</source>
        <translation>在光标下或选中的点旁边添加一个控制点</translation>
    </message>
    <message>
        <source>De&amp;lete point</source>
        <translation>删除点</translation>
    </message>
    <message>
        <source>Delete point</source>
        <translation>删除点</translation>
    </message>
    <message>
        <source>Delete the selected control points</source>
        <translation>删除选中的控制点</translation>
    </message>
    <message>
        <source>Smoo&amp;th point</source>
        <translation>平滑点</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>平滑</translation>
    </message>
    <message>
        <source>Make the contour smooth at the selected points</source>
        <translation>让轮廓在选中的点处平滑</translation>
    </message>
    <message>
        <source>S&amp;ymmetric point</source>
        <translation>对称点</translation>
    </message>
    <message>
        <source>Make the contour smooth, with handles of equal length on both sides</source>
        <translation>让轮廓平滑，两侧手柄一样长</translation>
    </message>
    <message>
        <source>&amp;Corner point</source>
        <translation>角点</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>角点</translation>
    </message>
    <message>
        <source>Make the selected points corners</source>
        <translation>把选中的点变成角点</translation>
    </message>
    <message>
        <source>No point of a contour is selected</source>
        <translation>没有选中轮廓上的点</translation>
    </message>
    <message>
        <source>Select one section whose contour can be edited</source>
        <translation>请先选中一个可以编辑轮廓的插片</translation>
    </message>
    <message>
        <source>The selection has no holes</source>
        <translation>所选内容没有孔</translation>
    </message>
    <message>
        <source>Move &amp;and turn</source>
        <translation>移动和转动</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>移动</translation>
    </message>
    <message>
        <source>Move, turn and scale with handles or numbers</source>
        <translation>用手柄或数字移动、转动和缩放</translation>
    </message>
    <message>
        <source>&amp;Along world axes</source>
        <translation>沿世界坐标轴</translation>
    </message>
    <message>
        <source>World axes</source>
        <translation>世界坐标轴</translation>
    </message>
    <message>
        <source>Move along the world&apos;s axes, not in the plane of the section</source>
        <translation>沿世界坐标轴移动，而不是在插片的平面内</translation>
    </message>
    <message>
        <source>&amp;Move attached sections</source>
        <translation>连同依附的插片移动</translation>
    </message>
    <message>
        <source>Move attached</source>
        <translation>一起移动</translation>
    </message>
    <message>
        <source>Sections that were drawn on this one move with it</source>
        <translation>画在这个插片上的插片会跟着移动</translation>
    </message>
    <message>
        <source>&amp;Put on another section…</source>
        <translation>放到另一个插片上…</translation>
    </message>
    <message>
        <source>Put on</source>
        <translation>放上去</translation>
    </message>
    <message>
        <source>Click the section to put the selected one on</source>
        <translation>点击要把所选插片放到哪个插片上</translation>
    </message>
    <message>
        <source>&amp;Free from its parent</source>
        <translation>脱离父插片</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>脱离</translation>
    </message>
    <message>
        <source>Unlink from its parent: it no longer moves with it or keeps its angle</source>
        <translation>与父插片断开：不再跟着它移动，也不再保持角度</translation>
    </message>
    <message>
        <source>Ma&amp;ke orthogonal</source>
        <translation>转到垂直</translation>
    </message>
    <message>
        <source>Orthogonal</source>
        <translation>垂直</translation>
    </message>
    <message>
        <source>Turn the section square to the one it is on</source>
        <translation>让插片与它所在的插片垂直</translation>
    </message>
    <message>
        <source>Align to nearest a&amp;xis</source>
        <translation>对齐到最近的轴</translation>
    </message>
    <message>
        <source>Align</source>
        <translation>对齐</translation>
    </message>
    <message>
        <source>Turn the section so that it faces along a world axis</source>
        <translation>转动插片，让它朝向一个世界坐标轴</translation>
    </message>
    <message>
        <source>Lo&amp;ck</source>
        <translation>锁定</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>锁定</translation>
    </message>
    <message>
        <source>Protect the selected sections from changes</source>
        <translation>保护选中的插片不被改动</translation>
    </message>
    <message>
        <source>Edit &amp;its source</source>
        <translation>编辑来源</translation>
    </message>
    <message>
        <source>Edit source</source>
        <translation>编辑来源</translation>
    </message>
    <message>
        <source>Select the section that the selected one is made from</source>
        <translation>选中用来生成所选插片的那个插片</translation>
    </message>
    <message>
        <source>Deta&amp;ch this one</source>
        <translation>分离这一个</translation>
    </message>
    <message>
        <source>Detach</source>
        <translation>分离</translation>
    </message>
    <message>
        <source>Turn the selected section into a drawn one; its operation still makes the others</source>
        <translation>把选中的插片变成手画的；其余的仍由它的操作生成</translation>
    </message>
    <message>
        <source>Lea&amp;ve this one out</source>
        <translation>略去这一个</translation>
    </message>
    <message>
        <source>Leave out</source>
        <translation>略去</translation>
    </message>
    <message>
        <source>Leave the selected section out; its operation still makes the others</source>
        <translation>略去选中的插片；其余的仍由它的操作生成</translation>
    </message>
    <message>
        <source>The selection is not on another section</source>
        <translation>所选内容不在别的插片上</translation>
    </message>
    <message>
        <source>The selection is made by an operation</source>
        <translation>所选内容由操作生成</translation>
    </message>
    <message>
        <source>The selection is not symmetric</source>
        <translation>所选内容不对称</translation>
    </message>
    <message>
        <source>The selection is drawn, not made by an operation</source>
        <translation>所选内容是手画的，不是操作生成的</translation>
    </message>
    <message>
        <source>Select &amp;all</source>
        <translation>全选</translation>
    </message>
    <message>
        <source>Select all</source>
        <translation>全选</translation>
    </message>
    <message>
        <source>Select all sections</source>
        <translation>选中所有插片</translation>
    </message>
    <message>
        <source>Select ne&amp;xt</source>
        <translation>选择下一个</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>下一个</translation>
    </message>
    <message>
        <source>Select the next section</source>
        <translation>选中下一个插片</translation>
    </message>
    <message>
        <source>Select pre&amp;vious</source>
        <translation>选择上一个</translation>
    </message>
    <message>
        <source>Previous</source>
        <translation>上一个</translation>
    </message>
    <message>
        <source>Select the section before this one</source>
        <translation>选中上一个插片</translation>
    </message>
    <message>
        <source>Select co&amp;nnected</source>
        <translation>选择相连的</translation>
    </message>
    <message>
        <source>Connected</source>
        <translation>相连的</translation>
    </message>
    <message>
        <source>Select all sections that are connected to the selected ones</source>
        <translation>选中与所选插片相连的所有插片</translation>
    </message>
    <message>
        <source>&amp;Select parallel</source>
        <translation>选择平行的</translation>
    </message>
    <message>
        <source>Parallel</source>
        <translation>平行的</translation>
    </message>
    <message>
        <source>Select all sections parallel to the selected ones</source>
        <translation>选中与所选插片平行的所有插片</translation>
    </message>
    <message>
        <source>Select same stoc&amp;k</source>
        <translation>选择同种材料</translation>
    </message>
    <message>
        <source>Same stock</source>
        <translation>同种材料</translation>
    </message>
    <message>
        <source>Select all sections of the same stock as the selected ones</source>
        <translation>选中与所选插片材料相同的所有插片</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>新建</translation>
    </message>
    <message>
        <source>New</source>
        <translation>新建</translation>
    </message>
    <message>
        <source>Start a new model</source>
        <translation>开始一个新模型</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>撤销</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>撤销</translation>
    </message>
    <message>
        <source>Undo the last step</source>
        <translation>撤销上一步</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>重做</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>重做</translation>
    </message>
    <message>
        <source>Redo the step that was undone</source>
        <translation>重做撤销的步骤</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Delete the selected sections</source>
        <translation>删除选中的插片</translation>
    </message>
    <message>
        <source>Set a point</source>
        <translation>放置一个点</translation>
    </message>
    <message>
        <source>Nothing to undo</source>
        <translation>没有可撤销的内容</translation>
    </message>
    <message>
        <source>&amp;Undo “%1”</source>
        <extracomment>%1 is a step of the history</extracomment>
        <translation>撤销“%1”</translation>
    </message>
    <message>
        <source>Nothing to redo</source>
        <translation>没有可重做的内容</translation>
    </message>
    <message>
        <source>&amp;Redo “%1”</source>
        <extracomment>%1 is a step of the history</extracomment>
        <translation>重做“%1”</translation>
    </message>
    <message>
        <source>&amp;Unpin all parts</source>
        <translation>取消固定所有零件</translation>
    </message>
    <message>
        <source>Unpin all</source>
        <translation>全部取消固定</translation>
    </message>
    <message>
        <source>Let all parts be moved again when they are laid on sheets</source>
        <translation>排版时，所有零件又可以移动</translation>
    </message>
    <message>
        <source>No part is pinned to its sheet</source>
        <translation>没有固定在板材上的零件</translation>
    </message>
    <message>
        <source>S&amp;kin</source>
        <translation>蒙皮</translation>
    </message>
    <message>
        <source>Skin</source>
        <translation>蒙皮</translation>
    </message>
    <message>
        <source>Show the form that the sections suggest, as a surface over them</source>
        <translation>把插片勾勒出的形体显示为覆盖其上的曲面</translation>
    </message>
    <message>
        <source>Local &amp;symmetry</source>
        <translation>局部对称</translation>
    </message>
    <message>
        <source>Symmetry</source>
        <translation>对称</translation>
    </message>
    <message>
        <source>Mirror a contour across its slit when it is drawn on one side of it</source>
        <translation>轮廓只画在插槽一侧时，把它镜像到另一侧</translation>
    </message>
    <message>
        <source>Cut flat at the &amp;ground</source>
        <translation>在地面处切平</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>地面</translation>
    </message>
    <message>
        <source>Cut off what is drawn below the ground</source>
        <translation>切掉画在地面以下的部分</translation>
    </message>
    <message>
        <source>On the gr&amp;ound</source>
        <translation>在地面上</translation>
    </message>
    <message>
        <source>On the ground</source>
        <translation>在地面上</translation>
    </message>
    <message>
        <source>Draw a section that lies on the ground</source>
        <translation>画一个平放在地面上的插片</translation>
    </message>
    <message>
        <source>On the &amp;front plane</source>
        <translation>在前平面上</translation>
    </message>
    <message>
        <source>On the front</source>
        <translation>前平面</translation>
    </message>
    <message>
        <source>Draw a section upright in the middle, seen from the front</source>
        <translation>从前面看，在中间画一个竖立的插片</translation>
    </message>
    <message>
        <source>On the s&amp;ide plane</source>
        <translation>在侧平面上</translation>
    </message>
    <message>
        <source>On the side</source>
        <translation>侧平面</translation>
    </message>
    <message>
        <source>Draw a section upright in the middle, seen from the side</source>
        <translation>从侧面看，在中间画一个竖立的插片</translation>
    </message>
    <message>
        <source>&amp;Parallel to the section</source>
        <translation>与插片平行</translation>
    </message>
    <message>
        <source>Draw a section parallel to the selected one</source>
        <translation>画一个与选中插片平行的插片</translation>
    </message>
    <message>
        <source>&amp;Redraw contour</source>
        <translation>重画轮廓</translation>
    </message>
    <message>
        <source>Redraw</source>
        <translation>重画</translation>
    </message>
    <message>
        <source>Draw a new contour for the selected section</source>
        <translation>为选中的插片画一个新轮廓</translation>
    </message>
    <message>
        <source>Draw a &amp;hole</source>
        <translation>画孔</translation>
    </message>
    <message>
        <source>Hole</source>
        <translation>孔</translation>
    </message>
    <message>
        <source>Draw a hole in the selected section</source>
        <translation>在选中的插片上画一个孔</translation>
    </message>
    <message>
        <source>Drop to gro&amp;und</source>
        <translation>落到地面</translation>
    </message>
    <message>
        <source>Drop</source>
        <translation>落地</translation>
    </message>
    <message>
        <source>Set the model down on the ground</source>
        <translation>把模型放到地面上</translation>
    </message>
    <message>
        <source>The model is on the ground already</source>
        <translation>模型已经在地面上</translation>
    </message>
    <message>
        <source>Share for adjusting</source>
        <translation>交给别人调整</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>交付</translation>
    </message>
    <message>
        <source>Whoever opens the saved model sees the view, the shown values and Export, and nothing else</source>
        <translation>别人打开保存的模型时，只会看到视图、公开的参数和导出，没有其他</translation>
    </message>
    <message>
        <source>Edit the design</source>
        <translation>编辑设计</translation>
    </message>
    <message>
        <source>Others can adjust no value yet</source>
        <translation>还没有别人可以调整的参数</translation>
    </message>
    <message>
        <source>&amp;Front</source>
        <translation>前视</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>前视</translation>
    </message>
    <message>
        <source>Look from the front</source>
        <translation>从前面看</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>俯视</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>俯视</translation>
    </message>
    <message>
        <source>Look from the top</source>
        <translation>从上面看</translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation>右视</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>右视</translation>
    </message>
    <message>
        <source>Look from the right</source>
        <translation>从右面看</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>后视</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>后视</translation>
    </message>
    <message>
        <source>Look from the back</source>
        <translation>从后面看</translation>
    </message>
    <message>
        <source>Botto&amp;m</source>
        <translation>仰视</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>仰视</translation>
    </message>
    <message>
        <source>Look from below</source>
        <translation>从下面看</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>左视</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>左视</translation>
    </message>
    <message>
        <source>Look from the left</source>
        <translation>从左面看</translation>
    </message>
    <message>
        <source>Next &amp;corner</source>
        <translation>下一个角</translation>
    </message>
    <message>
        <source>Look from the next corner</source>
        <translation>从下一个角看</translation>
    </message>
    <message>
        <source>Face the &amp;section</source>
        <translation>正对插片</translation>
    </message>
    <message>
        <source>Face</source>
        <translation>正对</translation>
    </message>
    <message>
        <source>Look straight at the selected section</source>
        <translation>正对选中的插片看</translation>
    </message>
    <message>
        <source>Fit &amp;everything</source>
        <translation>适应全部</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>适应</translation>
    </message>
    <message>
        <source>Show the whole model</source>
        <translation>显示整个模型</translation>
    </message>
    <message>
        <source>F&amp;it selection</source>
        <translation>适应所选</translation>
    </message>
    <message>
        <source>Fit selection</source>
        <translation>适应所选</translation>
    </message>
    <message>
        <source>Show the selected sections as large as possible</source>
        <translation>把选中的插片显示得尽可能大</translation>
    </message>
    <message>
        <source>&amp;Previous view</source>
        <translation>上一个视图</translation>
    </message>
    <message>
        <source>Go back to the view before this one</source>
        <translation>回到前一个视图</translation>
    </message>
    <message>
        <source>Perspecti&amp;ve</source>
        <translation>透视</translation>
    </message>
    <message>
        <source>Perspective</source>
        <translation>透视</translation>
    </message>
    <message>
        <source>Show what is farther away smaller, as the eye sees it</source>
        <translation>远处的东西显示得小一些，就像眼睛看到的那样</translation>
    </message>
    <message>
        <source>&amp;X-ray</source>
        <translation>X 光</translation>
    </message>
    <message>
        <source>X-ray</source>
        <translation>X 光</translation>
    </message>
    <message>
        <source>See through all sections, down to their slits</source>
        <translation>看穿所有插片，直到它们的插槽</translation>
    </message>
    <message>
        <source>Onl&amp;y the selection</source>
        <translation>只看所选</translation>
    </message>
    <message>
        <source>Isolate</source>
        <translation>只看所选</translation>
    </message>
    <message>
        <source>Fade all other sections</source>
        <translation>淡化所有其他插片</translation>
    </message>
    <message>
        <source>&amp;Hide</source>
        <translation>隐藏</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>隐藏</translation>
    </message>
    <message>
        <source>Hide the selected sections</source>
        <translation>隐藏选中的插片</translation>
    </message>
    <message>
        <source>Show &amp;all</source>
        <translation>全部显示</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>全部显示</translation>
    </message>
    <message>
        <source>Show the hidden sections again</source>
        <translation>重新显示隐藏的插片</translation>
    </message>
    <message>
        <source>Cut view &amp;open</source>
        <translation>剖开视图</translation>
    </message>
    <message>
        <source>Cut open</source>
        <translation>剖开</translation>
    </message>
    <message>
        <source>Cut the model open with a plane, to look inside</source>
        <translation>用一个平面把模型剖开，看看里面</translation>
    </message>
    <message>
        <source>&amp;Ground and shadow</source>
        <translation>地面和阴影</translation>
    </message>
    <message>
        <source>Show the ground with its grid and the model&apos;s shadow</source>
        <translation>显示带方格的地面和模型的阴影</translation>
    </message>
    <message>
        <source>Stress &amp;lines</source>
        <translation>应力线</translation>
    </message>
    <message>
        <source>Stress</source>
        <translation>应力</translation>
    </message>
    <message>
        <source>Show where the model is strained most</source>
        <translation>显示模型哪里受力最大</translation>
    </message>
    <message>
        <source>No section is hidden</source>
        <translation>没有隐藏的插片</translation>
    </message>
    <message>
        <source>There is no view before this one</source>
        <translation>没有更早的视图</translation>
    </message>
    <message>
        <source>The simple window does without it; Settings have the whole one</source>
        <translation>简洁窗口里没有它；在“设置”中可换回完整窗口</translation>
    </message>
    <message>
        <source>Your first model in 3 &amp;minutes</source>
        <translation>3 分钟做出第一个模型</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>导览</translation>
    </message>
    <message>
        <source>Draw, check and cut a model step by step, in an empty window</source>
        <translation>在空窗口里一步步画出、检查并切割一个模型</translation>
    </message>
    <message>
        <source>Help on what is under the cursor</source>
        <translation>光标下内容的帮助</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>帮助</translation>
    </message>
    <message>
        <source>Open the help where it tells about this part of the window</source>
        <translation>打开讲解窗口这一部分的帮助</translation>
    </message>
    <message>
        <source>Do not mirror</source>
        <translation>不做镜像</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Leave everything as it was</source>
        <translation>一切保持原样</translation>
    </message>
</context>
<context>
    <name>CommandLine</name>
    <message>
        <source>Prints JSON, for other programs.</source>
        <translation>输出 JSON，供其他程序使用。</translation>
    </message>
    <message>
        <source>Sections, joints, size and mass of a model</source>
        <translation>模型的插片、接头、尺寸和质量</translation>
    </message>
    <message>
        <source>Whether it holds together, stands, can be assembled and fits the sheet</source>
        <translation>是否连成一体、能站稳、可以拼装、板材放得下</translation>
    </message>
    <message>
        <source>Whether it is strong enough: forces, stress and what it can hold</source>
        <translation>是否够结实：力、应力和能承受多少</translation>
    </message>
    <message>
        <source>The parts to cut, in each section&apos;s own coordinates</source>
        <translation>要切割的零件，用各插片自己的坐标表示</translation>
    </message>
    <message>
        <source>A picture of the model; needs a display</source>
        <translation>模型的图片；需要显示设备</translation>
    </message>
    <message>
        <source>How it goes together, step by step; needs a display</source>
        <translation>怎样一步一步拼装；需要显示设备</translation>
    </message>
    <message>
        <source>The named values of a model, and what is made of them</source>
        <translation>模型中有名称的参数，以及由它们构成的内容</translation>
    </message>
    <message>
        <source>A cutting file and a verdict for each line of a table of values</source>
        <translation>为参数表的每一行写出一个切割文件和一个结论</translation>
    </message>
    <message>
        <source>All kinds of operations, or the operations of a model</source>
        <translation>操作的所有种类，或模型中的操作</translation>
    </message>
    <message>
        <source>The loops in which a plane cuts a mesh</source>
        <translation>平面截网格得到的闭合曲线</translation>
    </message>
    <message>
        <source>Sections that show a mesh, stand and can be assembled</source>
        <translation>能表现网格、能站稳并可以拼装的插片</translation>
    </message>
    <message>
        <source>A model of a mesh in slices</source>
        <translation>由网格切片构成的模型</translation>
    </message>
    <message>
        <source>A model of flat sheets with fingers along their edges</source>
        <translation>由平板拼成、边缘带指接的模型</translation>
    </message>
    <message>
        <source>Parts close together on sheets, or the items of a strip (.json)</source>
        <translation>把零件紧密排在板材上，或排一个条带的工件（.json）</translation>
    </message>
    <message>
        <source>Plays a script of what a person does in the window</source>
        <translation>播放一段脚本，重现用户在窗口中的动作</translation>
    </message>
    <message>
        <source>Cut away completely by slits, so there is no part: %1</source>
        <translation>被插槽完全切掉，因此没有零件：%1</translation>
    </message>
    <message>
        <source>Too large for the sheet, on sheets of their own: %1</source>
        <translation>板材放不下，单独放在自己的板材上：%1</translation>
    </message>
    <message>
        <source>Too slim to carry a number: %1</source>
        <translation>太窄，写不下编号：%1</translation>
    </message>
    <message>
        <source>A hole or a notch narrower than the kerf is not cut: %1</source>
        <translation>有孔或缺口比切缝还窄，不会切割：%1</translation>
    </message>
    <message>
        <source>No room for the numbers of all joints: %1</source>
        <translation>写不下所有接头的编号：%1</translation>
    </message>
    <message>
        <source>Standard output could not be written.</source>
        <translation>无法写入标准输出。</translation>
    </message>
    <message>
        <source>Nothing to check: the model has no sections.</source>
        <translation>没有可检查的：模型没有插片。</translation>
    </message>
    <message numerus="yes">
        <source>%n sections</source>
        <translation>
            <numerusform>%n 个插片</numerusform>
        </translation>
    </message>
    <message>
        <source>Sections bend where joints share a load, by finite elements; takes seconds.</source>
        <translation>接头分担载荷时插片会弯曲，用有限元计算；需要几秒。</translation>
    </message>
    <message>
        <source>The load stays for months: each stock keeps only its share of strength for that.</source>
        <translation>载荷持续数月：各种材料只保留其长期强度比例。</translation>
    </message>
    <message>
        <source>There is no &quot;%1&quot;.</source>
        <translation>没有“%1”。</translation>
    </message>
    <message>
        <source>DXF with layers by purpose</source>
        <translation>按用途分图层的 DXF</translation>
    </message>
    <message>
        <source>Version of a DXF file: r2000 or r12 (r2000).</source>
        <translation>DXF 文件的版本：r2000 或 r12（r2000）。</translation>
    </message>
    <message>
        <source>the model itself</source>
        <translation>模型本身</translation>
    </message>
    <message>
        <source>Millimetres per unit of a FlatFab file (25.4).</source>
        <translation>FlatFab 文件每单位的毫米数（25.4）。</translation>
    </message>
    <message>
        <source>G-code for lasers</source>
        <translation>激光机用的 G-code</translation>
    </message>
    <message>
        <source>a LightBurn project</source>
        <translation>LightBurn 项目</translation>
    </message>
    <message>
        <source>the solids in place</source>
        <translation>原位的实体</translation>
    </message>
    <message>
        <source>the list of parts</source>
        <translation>零件清单</translation>
    </message>
    <message>
        <source>PDF in true size</source>
        <translation>实际尺寸的 PDF</translation>
    </message>
    <message>
        <source>Pages of a PDF file: sheet, or tiles on a4 or letter (sheet).</source>
        <translation>PDF 文件的页面：sheet（每张板材一页），或分页拼接到 a4 或 letter（sheet）。</translation>
    </message>
    <message>
        <source>a picture of the sheets</source>
        <translation>板材的图片</translation>
    </message>
    <message>
        <source>How parts lie in an STL or 3MF file: in-place, or flat on their sheets (in-place).</source>
        <translation>零件在 STL 或 3MF 文件中的摆放：in-place（原位）或 flat（平放在板材上）（in-place）。</translation>
    </message>
    <message>
        <source>the parts to print</source>
        <translation>用于打印的零件</translation>
    </message>
    <message>
        <source>cutting files, true to size</source>
        <translation>切割文件，实际尺寸</translation>
    </message>
    <message>
        <source>all for a workshop</source>
        <translation>加工所需的全部文件</translation>
    </message>
    <message>
        <source>there is no display with OpenGL 3.3.</source>
        <translation>没有支持 OpenGL 3.3 的显示器。</translation>
    </message>
    <message>
        <source>The search was stopped before its end, since this machine is busy: another run may come to another layout.</source>
        <translation>由于本机繁忙，搜索提前停止：再次运行可能得到不同的排样。</translation>
    </message>
</context>
<context>
    <name>Coupon</name>
    <message>
        <source>Slits to try</source>
        <translation>试插的插槽</translation>
    </message>
    <message>
        <source>Strip to push in</source>
        <translation>用来插入的条</translation>
    </message>
    <message>
        <source>Slat to measure</source>
        <translation>用来测量的条</translation>
    </message>
</context>
<context>
    <name>Cue</name>
    <message>
        <source>Too near the edge: the slit would hold nothing</source>
        <translation>离边缘太近：插槽会固定不住</translation>
    </message>
    <message>
        <source>Too near the edge: the slit would hold nothing. B: move it in</source>
        <translation>离边缘太近：插槽会固定不住。B：往里移</translation>
    </message>
    <message>
        <source>Moved in by %1. B: put it back</source>
        <extracomment>%1 is a length</extracomment>
        <translation>往里移了 %1。B：移回去</translation>
    </message>
    <message>
        <source>level</source>
        <translation>水平</translation>
    </message>
    <message>
        <source>upright</source>
        <translation>竖直</translation>
    </message>
    <message>
        <source>square to the edge</source>
        <translation>与边缘垂直</translation>
    </message>
    <message>
        <source>parallel to the last one</source>
        <translation>与上一个平行</translation>
    </message>
    <message>
        <source>Turning…</source>
        <translation>正在转动…</translation>
    </message>
    <message>
        <source>Draw the outline</source>
        <translation>画出轮廓</translation>
    </message>
    <message>
        <source>Not joined yet</source>
        <extracomment>beside the cursor, while a contour does not reach its slit</extracomment>
        <translation>还没连上</translation>
    </message>
</context>
<context>
    <name>Driven</name>
    <message>
        <source>“%1” is %2, which is not possible here.</source>
        <extracomment>%1: an expression, %2 what it comes to</extracomment>
        <translation>“%1”为 %2，在这里不行。</translation>
    </message>
    <message>
        <source>“%1” and another expression want this to be different at the same time.</source>
        <extracomment>%1: an expression</extracomment>
        <translation>“%1”和另一个表达式同时要求这里取不同的值。</translation>
    </message>
    <message>
        <source>What this number belongs to is not there any more.</source>
        <translation>这个数字所属的对象已经不在了。</translation>
    </message>
    <message>
        <source>Dimension</source>
        <translation>尺寸</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>宽度</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高度</translation>
    </message>
    <message>
        <source>X of the centre</source>
        <translation>中心 X</translation>
    </message>
    <message>
        <source>Y of the centre</source>
        <translation>中心 Y</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>转动</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>文字</translation>
    </message>
    <message>
        <source>Height of letters</source>
        <translation>字高</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>厚度</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>间隙</translation>
    </message>
    <message>
        <source>Kerf</source>
        <translation>切缝</translation>
    </message>
    <message>
        <source>Width of a sheet</source>
        <translation>板材宽度</translation>
    </message>
    <message>
        <source>Height of a sheet</source>
        <translation>板材高度</translation>
    </message>
    <message>
        <source>Diameter of the tool</source>
        <translation>刀具直径</translation>
    </message>
    <message>
        <source>Lead-in of slits</source>
        <translation>插槽导入倒角</translation>
    </message>
    <message>
        <source>Bumps in slits</source>
        <translation>插槽凸点</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>质量</translation>
    </message>
    <message>
        <source>Filled with</source>
        <translation>盛装</translation>
    </message>
    <message>
        <source>Force along X</source>
        <translation>X 方向的力</translation>
    </message>
    <message>
        <source>Force along Y</source>
        <translation>Y 方向的力</translation>
    </message>
    <message>
        <source>Force across</source>
        <translation>垂直于板面的力</translation>
    </message>
    <message>
        <source>Meeting point</source>
        <translation>相接点</translation>
    </message>
    <message>
        <source>“%1” is not possible here: numbers that follow values keep it at %2.</source>
        <extracomment>%1: what was typed, %2 a length or the like</extracomment>
        <translation>这里不能用“%1”：跟随参数的数值使它保持在 %2。</translation>
    </message>
    <message>
        <source>“%1” is not possible here: %2 follows “%3”, which keeps it as it is.</source>
        <extracomment>%1: what was typed, %2 names a number such as &quot;Wheel, Diameter&quot;, %3: an expression</extracomment>
        <translation>这里不能用“%1”：%2 跟随“%3”，使它保持不变。</translation>
    </message>
    <message>
        <source>“%1” cannot be worked out.</source>
        <extracomment>%1 is the name of a value</extracomment>
        <translation>“%1”无法计算。</translation>
    </message>
    <message>
        <source>“%1” is empty, which is not possible here.</source>
        <extracomment>%1: an expression</extracomment>
        <translation>“%1”是空的，这里不允许。</translation>
    </message>
</context>
<context>
    <name>Error</name>
    <message>
        <source>there is not enough memory</source>
        <translation>内存不足</translation>
    </message>
    <message>
        <source>a mesh: this is flat</source>
        <translation>网格：这是平的</translation>
    </message>
    <message>
        <source>bytes</source>
        <translation>字节</translation>
    </message>
    <message>
        <source>entries</source>
        <translation>条目</translation>
    </message>
    <message>
        <source>its list of contents is damaged</source>
        <translation>它的目录已损坏</translation>
    </message>
    <message>
        <source>this entry is damaged</source>
        <translation>这个条目已损坏</translation>
    </message>
    <message>
        <source>this entry is encrypted</source>
        <translation>这个条目已加密</translation>
    </message>
    <message>
        <source>there is more in this file than its contents</source>
        <translation>这个文件里除了目录所列，还有别的内容</translation>
    </message>
    <message>
        <source>this entry occurs twice</source>
        <translation>这个条目出现了两次</translation>
    </message>
    <message>
        <source>this entry is packed in an unknown way</source>
        <translation>这个条目的打包方式未知</translation>
    </message>
    <message>
        <source>this entry has another name than in the list of contents</source>
        <translation>这个条目的名称与目录中的不同</translation>
    </message>
    <message>
        <source>entries in it share their bytes</source>
        <translation>其中的条目共用了字节</translation>
    </message>
    <message>
        <source>this entry unpacks to far too much</source>
        <translation>这个条目解包后过于庞大</translation>
    </message>
    <message>
        <source>undamaged gzip data</source>
        <translation>完好的 gzip 数据</translation>
    </message>
    <message>
        <source>the rest of the gzip data</source>
        <translation>gzip 数据的其余部分</translation>
    </message>
    <message>
        <source>a larger sheet</source>
        <translation>更大的板材</translation>
    </message>
    <message>
        <source>a file needs a name</source>
        <translation>文件需要一个名称</translation>
    </message>
    <message>
        <source>this file is read-only</source>
        <translation>这个文件是只读的</translation>
    </message>
    <message>
        <source>this folder is read-only</source>
        <translation>这个文件夹是只读的</translation>
    </message>
    <message>
        <source>a model</source>
        <translation>模型</translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation>这是一个文件夹</translation>
    </message>
    <message>
        <source>this value is not allowed here</source>
        <translation>这里不允许这个值</translation>
    </message>
    <message>
        <source>found nothing, expected %1</source>
        <translation>什么都没读到，应为：%1</translation>
    </message>
    <message>
        <source>found &quot;%1&quot;, expected %2</source>
        <translation>读到“%1”，应为：%2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>%1 is a sentence such as &quot;could not be opened&quot;, %2 the system&apos;s reason</extracomment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>this count is not possible</source>
        <translation>这个个数不可能</translation>
    </message>
    <message>
        <source>found a count of %1, expected at most %2</source>
        <translation>读到的个数为 %1，应为：最多 %2</translation>
    </message>
    <message>
        <source>found %1 %3, expected at most %2 %3</source>
        <extracomment>%3 is what was counted, such as &quot;bytes&quot;</extracomment>
        <translation>读到 %1 %3，应为：最多 %2 %3</translation>
    </message>
    <message>
        <source>made by a newer FlatFitFab</source>
        <translation>由更新版本的 FlatFitFab 生成</translation>
    </message>
    <message>
        <source>made by a newer FlatFitFab: found format %1, expected at most %2</source>
        <translation>由更新版本的 FlatFitFab 生成：读到格式 %1，应为：最高 %2</translation>
    </message>
    <message>
        <source>these control points do not form a closed contour</source>
        <translation>这些控制点没有构成闭合轮廓</translation>
    </message>
    <message>
        <source>these control points do not form a closed contour: found %1, expected %2</source>
        <translation>这些控制点没有构成闭合轮廓：读到 %1，应为：%2</translation>
    </message>
    <message>
        <source>no path can follow this outline at half the kerf all the way round</source>
        <translation>没有路径能以半个切缝的距离绕这条轮廓线一整圈</translation>
    </message>
    <message>
        <source>no path can follow %1 at half the kerf of %2 mm all the way round; smooth the finest details of its contour, or give its stock another kerf</source>
        <translation>没有路径能以 %2 mm 切缝的一半为距离绕 %1 一整圈；请把轮廓上最细的地方改平滑，或给它的材料设置别的切缝</translation>
    </message>
    <message>
        <source>the kerf closes a slit</source>
        <translation>切缝会填没插槽</translation>
    </message>
    <message>
        <source>%1 has a slit %2 mm wide, which a kerf of %3 mm would close</source>
        <translation>%1 有一个 %2 mm 宽的插槽，%3 mm 的切缝会把它填没</translation>
    </message>
    <message>
        <source>a %1 file</source>
        <extracomment>%1 is the end of a name, such as &quot;.txt&quot;, %2 a program</extracomment>
        <translation>%1 文件</translation>
    </message>
    <message>
        <source>a %1 file of %2</source>
        <translation>%2 的 %1 文件</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 或 %2</translation>
    </message>
    <message>
        <source>could not be opened</source>
        <translation>无法打开</translation>
    </message>
    <message>
        <source>could not be written</source>
        <translation>无法写入</translation>
    </message>
    <message>
        <source>not a model, expected %1</source>
        <translation>不是模型，应为：%1</translation>
    </message>
    <message>
        <source>the file ends here, expected %1</source>
        <translation>文件到此结束，应为：%1</translation>
    </message>
    <message>
        <source>the file ends too early</source>
        <translation>文件结束得太早</translation>
    </message>
    <message>
        <source>found &quot;%1&quot;, expected a finite number</source>
        <translation>读到“%1”，应为：有限的数</translation>
    </message>
    <message>
        <source>a number is not finite</source>
        <translation>有个数不是有限的</translation>
    </message>
    <message>
        <source>these axes do not form a frame, expected two of length 1 at a right angle</source>
        <translation>这些轴不能构成坐标系，应为：两条长度为 1、互相垂直的轴</translation>
    </message>
    <message>
        <source>this contour encloses no area</source>
        <translation>这个轮廓没有围出面积</translation>
    </message>
    <message>
        <source>there is nothing with the number %1</source>
        <translation>没有编号为 %1 的对象</translation>
    </message>
    <message>
        <source>this refers to something that does not exist</source>
        <translation>这里引用了不存在的内容</translation>
    </message>
    <message>
        <source>the number %1 is used twice, expected one of its own</source>
        <translation>编号 %1 用了两次，应为：各自不同的编号</translation>
    </message>
    <message>
        <source>this number is used twice, expected one of its own</source>
        <translation>这个编号用了两次，应为：各自不同的编号</translation>
    </message>
    <message>
        <source>these two sections are nearly parallel and cannot be joined</source>
        <translation>这两个插片几乎平行，无法连接</translation>
    </message>
    <message>
        <source>this contour crosses itself</source>
        <translation>这个轮廓与自身交叉</translation>
    </message>
    <message>
        <source>a hole would touch the edge or another hole</source>
        <translation>孔会碰到边缘或另一个孔</translation>
    </message>
    <message>
        <source>too few points would be left to enclose anything</source>
        <translation>剩下的点太少，围不成任何东西</translation>
    </message>
    <message>
        <source>slits leave nothing of any section, so there is nothing to cut</source>
        <translation>插槽把所有插片都切得什么都不剩，所以没有可切割的</translation>
    </message>
    <message>
        <source>there is no section yet, so there is nothing to cut</source>
        <translation>还没有插片，所以没有可切割的</translation>
    </message>
    <message>
        <source>none of the places between its contours can be covered (%1), so there is no skin</source>
        <translation>轮廓之间没有任何一处能覆盖（%1），所以没有蒙皮</translation>
    </message>
    <message>
        <source>no contours cross each other at their edges, so there is no skin</source>
        <translation>没有轮廓在边缘处相交，所以没有蒙皮</translation>
    </message>
    <message>
        <source>there is no command &quot;%1&quot;</source>
        <translation>没有命令“%1”</translation>
    </message>
    <message>
        <source>there is no such command</source>
        <translation>没有这个命令</translation>
    </message>
    <message>
        <source>this event makes no sense here</source>
        <translation>这个事件在这里没有意义</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not supported by this version</source>
        <translation>这个版本不支持“%1”</translation>
    </message>
    <message>
        <source>this is not supported by this version</source>
        <translation>这个版本不支持</translation>
    </message>
    <message>
        <source>this could not be worked out</source>
        <translation>无法算出</translation>
    </message>
    <message>
        <source>&quot;%1&quot; could not be cut out: what its slits leave of it could not be worked out</source>
        <translation>无法切出“%1”：算不出开完插槽后还剩什么</translation>
    </message>
    <message>
        <source>a section could not be cut out</source>
        <translation>有个插片无法切出</translation>
    </message>
    <message>
        <source>the solid of &quot;%1&quot; could not be worked out</source>
        <translation>无法算出“%1”的实体</translation>
    </message>
    <message>
        <source>a solid could not be worked out</source>
        <translation>有个实体无法算出</translation>
    </message>
    <message>
        <source>the marks on &quot;%1&quot; could not be trimmed at its edge</source>
        <translation>“%1”上的标记无法沿边缘修剪</translation>
    </message>
    <message>
        <source>the marks on a section could not be trimmed at its edge</source>
        <translation>有个插片上的标记无法沿边缘修剪</translation>
    </message>
    <message>
        <source>the sections of the operation &quot;%1&quot; could not be worked out</source>
        <translation>无法算出操作“%1”的插片</translation>
    </message>
    <message>
        <source>the sections of an operation could not be worked out</source>
        <translation>有个操作的插片无法算出</translation>
    </message>
    <message>
        <source>something went wrong inside FlatFitFab (%1)</source>
        <translation>FlatFitFab 内部出错（%1）</translation>
    </message>
    <message>
        <source>something went wrong inside FlatFitFab</source>
        <translation>FlatFitFab 内部出错</translation>
    </message>
    <message>
        <source>it was stopped</source>
        <translation>已被停止</translation>
    </message>
    <message>
        <source>the contents of this file are damaged</source>
        <translation>这个文件的内容已损坏</translation>
    </message>
    <message>
        <source>%1 was slightly skewed and has been straightened</source>
        <translation>%1 略有歪斜，已校正</translation>
    </message>
    <message>
        <source>a section was slightly skewed and has been straightened</source>
        <translation>一个插片略有歪斜，已校正</translation>
    </message>
    <message>
        <source>the contour of %1 crosses itself; its largest loop was kept</source>
        <translation>%1 的轮廓与自身交叉；保留了最大的一圈</translation>
    </message>
    <message>
        <source>a contour crosses itself; its largest loop was kept</source>
        <translation>有个轮廓与自身交叉；保留了最大的一圈</translation>
    </message>
    <message>
        <source>a hole of %1 reaches beyond its contour and was left out</source>
        <translation>%1 的一个孔超出了轮廓，已略去</translation>
    </message>
    <message>
        <source>a hole reaches beyond its contour and was left out</source>
        <translation>一个孔超出了轮廓，已略去</translation>
    </message>
    <message>
        <source>a hole of %1 has no area and was left out</source>
        <translation>%1 的一个孔没有面积，已略去</translation>
    </message>
    <message>
        <source>a hole has no area and was left out</source>
        <translation>一个孔没有面积，已略去</translation>
    </message>
    <message>
        <source>holes of %1 overlap and were merged into one</source>
        <translation>%1 的几个孔重叠，已合并为一个</translation>
    </message>
    <message>
        <source>holes overlap and were merged into one</source>
        <translation>几个孔重叠，已合并为一个</translation>
    </message>
    <message>
        <source>a hole of %1 reaches beyond its contour and was cut out of it</source>
        <translation>%1 的一个孔超出了轮廓，已从轮廓中切去</translation>
    </message>
    <message>
        <source>a hole reaches beyond its contour and was cut out of it</source>
        <translation>一个孔超出了轮廓，已从轮廓中切去</translation>
    </message>
    <message>
        <source>lines after the last section were ignored</source>
        <translation>最后一个插片之后的各行已忽略</translation>
    </message>
    <message>
        <source>text after the last section was ignored, lines: %1</source>
        <translation>最后一个插片之后的文字已忽略，行：%1</translation>
    </message>
    <message>
        <source>%1 could not be read and was left out</source>
        <translation>%1 无法读取，已略去</translation>
    </message>
    <message>
        <source>a picture or a mesh was left out</source>
        <translation>一张图片或一个网格已略去</translation>
    </message>
    <message>
        <source>%1 was left out: %2</source>
        <extracomment>%2 is a reason such as &quot;its data is missing&quot;</extracomment>
        <translation>%1 已略去：%2</translation>
    </message>
    <message>
        <source>what %1 shows could not be read; its place was kept</source>
        <translation>%1 的内容无法读取；保留了它的位置</translation>
    </message>
    <message>
        <source>a template could not be read; its place was kept</source>
        <translation>一个参考物无法读取；保留了它的位置</translation>
    </message>
    <message>
        <source>engraved or scored</source>
        <translation>engraved 或 scored</translation>
    </message>
    <message>
        <source>three control points per segment and one more</source>
        <translation>每段三个控制点，再加一个</translation>
    </message>
    <message>
        <source>at least one line</source>
        <translation>至少一条线</translation>
    </message>
    <message>
        <source>two different places</source>
        <translation>两个不同的位置</translation>
    </message>
    <message>
        <source>a word of letters and digits, once</source>
        <translation>由字母和数字组成的词，只出现一次</translation>
    </message>
    <message>
        <source>its data is missing</source>
        <translation>缺少它的数据</translation>
    </message>
    <message>
        <source>a SHA-256 in 64 hexadecimal digits</source>
        <translation>64 位十六进制数字的 SHA-256</translation>
    </message>
    <message>
        <source>an entry with this name does not belong here</source>
        <translation>这里不该有叫这个名称的条目</translation>
    </message>
    <message>
        <source>the data of this entry does not match its name, a SHA-256</source>
        <translation>这个条目的数据与它的名称（SHA-256）不符</translation>
    </message>
    <message>
        <source>this entry is missing</source>
        <translation>缺少这个条目</translation>
    </message>
    <message>
        <source>nothing in the document refers to this entry</source>
        <translation>文档中没有任何内容引用这个条目</translation>
    </message>
    <message>
        <source>point, patch or edge</source>
        <translation>point、patch 或 edge</translation>
    </message>
    <message>
        <source>point, patch, edge or hanging</source>
        <translation>point、patch、edge 或 hanging</translation>
    </message>
    <message>
        <source>a width from 1 to 10000 mm</source>
        <translation>1 到 10000 mm 的宽度</translation>
    </message>
    <message>
        <source>a force [x, y, z] above 0, at most 1000000 N</source>
        <translation>大于 0、不超过 1000000 N 的力 [x, y, z]</translation>
    </message>
    <message>
        <source>a height from 0 to 10000 mm</source>
        <translation>0 到 10000 mm 的高度</translation>
    </message>
    <message>
        <source>a part of its mass</source>
        <translation>它质量的一部分</translation>
    </message>
    <message>
        <source>hidden or detached</source>
        <translation>hidden 或 detached</translation>
    </message>
    <message>
        <source>something other than made, each instance once</source>
        <translation>与自动生成不同的内容，每个实例一次</translation>
    </message>
    <message>
        <source>an id below nextId</source>
        <translation>小于 nextId 的 id</translation>
    </message>
    <message>
        <source>a share above 0, 1 at most</source>
        <translation>大于 0、不超过 1 的比例</translation>
    </message>
    <message>
        <source>more than minus the thickness</source>
        <translation>大于负的厚度</translation>
    </message>
    <message>
        <source>a width and a height above 0</source>
        <translation>大于 0 的宽度和高度</translation>
    </message>
    <message>
        <source>square, round, dogbone or tBone</source>
        <translation>square、round、dogbone 或 tBone</translation>
    </message>
    <message>
        <source>three control points per segment, at least 6</source>
        <translation>每段三个控制点，至少 6 个</translation>
    </message>
    <message>
        <source>proportion, left, right, bottom or top</source>
        <translation>proportion、left、right、bottom 或 top</translation>
    </message>
    <message>
        <source>a direction of length 1</source>
        <translation>长度为 1 的方向</translation>
    </message>
    <message>
        <source>crossLap, mortise, tabs or none</source>
        <translation>crossLap、mortise、tabs 或 none</translation>
    </message>
    <message>
        <source>a share from 0.05 to 0.95</source>
        <translation>0.05 到 0.95 的比例</translation>
    </message>
    <message>
        <source>something wanted of two sections, pairs ascending</source>
        <translation>对两个插片的要求，成对且按升序</translation>
    </message>
    <message>
        <source>a parent that does not descend from its child</source>
        <translation>不是自己子插片后代的父插片</translation>
    </message>
    <message>
        <source>at least one stock</source>
        <translation>至少一种材料</translation>
    </message>
    <message>
        <source>each part once, in the order of sections</source>
        <translation>每个零件一次，按插片的顺序</translation>
    </message>
    <message>
        <source>each section once, in their order</source>
        <translation>每个插片一次，按它们的顺序</translation>
    </message>
    <message>
        <source>none, half, quarter or free</source>
        <translation>none、half、quarter 或 free</translation>
    </message>
    <message>
        <source>mesh, picture or curves</source>
        <translation>mesh、picture 或 curves</translation>
    </message>
    <message>
        <source>nothing: only meshes are pulled</source>
        <translation>空：只有网格会被磁吸</translation>
    </message>
    <message>
        <source>a radius from 0.1 to 1000 mm</source>
        <translation>0.1 到 1000 mm 的半径</translation>
    </message>
    <message>
        <source>the path of a file</source>
        <translation>文件路径</translation>
    </message>
    <message>
        <source>a blob&apos;s SHA-256, or a file</source>
        <translation>数据块的 SHA-256，或文件</translation>
    </message>
    <message>
        <source>nothing: a mesh lies on no section</source>
        <translation>空：网格不放在插片上</translation>
    </message>
    <message>
        <source>a scale from 1e-9 to 1e9</source>
        <translation>1e-9 到 1e9 的缩放比例</translation>
    </message>
    <message>
        <source>an opacity from 0 to 1</source>
        <translation>0 到 1 的不透明度</translation>
    </message>
    <message>
        <source>decimals or groups</source>
        <translation>decimals 或 groups</translation>
    </message>
    <message>
        <source>an expression that is not that long</source>
        <translation>没有那么长的表达式</translation>
    </message>
    <message>
        <source>number, length, angle, count, mass, ratio, text, choice or switch</source>
        <translation>number、length、angle、count、mass、ratio、text、choice 或 switch</translation>
    </message>
    <message>
        <source>a name without “=”, each once</source>
        <translation>不含“=”的名称，每个只出现一次</translation>
    </message>
    <message>
        <source>each value once</source>
        <translation>每个参数只出现一次</translation>
    </message>
    <message>
        <source>a word of letters and digits, each once</source>
        <translation>由字母和数字组成的词，每个只出现一次</translation>
    </message>
    <message>
        <source>each number once</source>
        <translation>每个数只出现一次</translation>
    </message>
    <message>
        <source>a length of at most 1000000 mm</source>
        <translation>不超过 1000000 mm 的长度</translation>
    </message>
    <message>
        <source>a last control point that repeats the first</source>
        <translation>与第一个控制点相同的最后一个控制点</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>数</translation>
    </message>
    <message>
        <source>a count</source>
        <translation>个数</translation>
    </message>
    <message>
        <source>a point of two numbers</source>
        <translation>由两个数组成的点</translation>
    </message>
    <message>
        <source>three control points per segment and the first again, at least 7</source>
        <translation>每段三个控制点，最后重复第一个，至少 7 个</translation>
    </message>
    <message>
        <source>at least 1 curve</source>
        <translation>至少 1 条曲线</translation>
    </message>
    <message>
        <source>a buffer with bytes</source>
        <translation>含有字节的缓冲区</translation>
    </message>
    <message>
        <source>a buffer in the file</source>
        <translation>文件中的缓冲区</translation>
    </message>
    <message>
        <source>a length that its buffer has</source>
        <translation>不超过其缓冲区的长度</translation>
    </message>
    <message>
        <source>a type of numbers that glTF has</source>
        <translation>glTF 中有的数字类型</translation>
    </message>
    <message>
        <source>as many values as its buffer has</source>
        <translation>与其缓冲区一样多的值</translation>
    </message>
    <message>
        <source>as many numbers as belong there</source>
        <translation>该处应有的数字个数</translation>
    </message>
    <message>
        <source>a node that is not within itself</source>
        <translation>不包含自身的节点</translation>
    </message>
    <message>
        <source>a chunk of a GLB file</source>
        <translation>GLB 文件的数据块</translation>
    </message>
    <message>
        <source>version 2 of GLB</source>
        <translation>GLB 版本 2</translation>
    </message>
    <message>
        <source>a glTF file</source>
        <translation>glTF 文件</translation>
    </message>
    <message>
        <source>version 2 of glTF</source>
        <translation>glTF 版本 2</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>对象</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true 或 false</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>列表</translation>
    </message>
    <message>
        <source>a number above 0, at most 1000000</source>
        <translation>大于 0、不超过 1000000 的数</translation>
    </message>
    <message>
        <source>a number from 0 to 1000000</source>
        <translation>0 到 1000000 的数</translation>
    </message>
    <message>
        <source>a whole number in its range</source>
        <translation>范围内的整数</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>文本</translation>
    </message>
    <message>
        <source>a point [x, y]</source>
        <translation>点 [x, y]</translation>
    </message>
    <message>
        <source>a point [x, y, z]</source>
        <translation>点 [x, y, z]</translation>
    </message>
    <message>
        <source>a list of points</source>
        <translation>点的列表</translation>
    </message>
    <message>
        <source>a name in quotes or the end of the object</source>
        <translation>带引号的名称或对象的结尾</translation>
    </message>
    <message>
        <source>a colon</source>
        <translation>冒号</translation>
    </message>
    <message>
        <source>a comma or the end of the list</source>
        <translation>逗号或列表的结尾</translation>
    </message>
    <message>
        <source>an escape sequence of JSON</source>
        <translation>JSON 转义序列</translation>
    </message>
    <message>
        <source>text in UTF-8</source>
        <translation>UTF-8 文本</translation>
    </message>
    <message>
        <source>the end of the text in quotes</source>
        <translation>带引号文本的结尾</translation>
    </message>
    <message>
        <source>another value after the comma</source>
        <translation>逗号后的另一个值</translation>
    </message>
    <message>
        <source>no more than 1024 levels</source>
        <translation>不超过 1024 层</translation>
    </message>
    <message>
        <source>a smaller file</source>
        <translation>更小的文件</translation>
    </message>
    <message>
        <source>the end of the file</source>
        <translation>文件结尾</translation>
    </message>
    <message>
        <source>a value</source>
        <translation>值</translation>
    </message>
    <message>
        <source>each key of an object only once</source>
        <translation>对象的每个键只出现一次</translation>
    </message>
    <message>
        <source>both halves of a character</source>
        <translation>一个字符的两半</translation>
    </message>
    <message>
        <source>a colour such as #ff0000</source>
        <translation>#ff0000 之类的颜色</translation>
    </message>
    <message>
        <source>a width of lines in mm</source>
        <translation>以 mm 为单位的线宽</translation>
    </message>
    <message>
        <source>a speed in mm/s</source>
        <translation>以 mm/s 为单位的速度</translation>
    </message>
    <message>
        <source>a line of G-code</source>
        <translation>一行 G-code</translation>
    </message>
    <message>
        <source>lines of G-code</source>
        <translation>若干行 G-code</translation>
    </message>
    <message>
        <source>the largest S</source>
        <translation>最大的 S 值</translation>
    </message>
    <message>
        <source>width and height in mm</source>
        <translation>以 mm 为单位的宽度和高度</translation>
    </message>
    <message>
        <source>a share from 0 to 1</source>
        <translation>0 到 1 的比例</translation>
    </message>
    <message>
        <source>a width of tabs in mm</source>
        <translation>以 mm 为单位的微连宽度</translation>
    </message>
    <message>
        <source>a length of leads in mm</source>
        <translation>以 mm 为单位的引入线长度</translation>
    </message>
    <message>
        <source>machines</source>
        <translation>机器</translation>
    </message>
    <message>
        <source>a machine</source>
        <translation>机器</translation>
    </message>
    <message>
        <source>triangles</source>
        <translation>三角形</translation>
    </message>
    <message>
        <source>vertices</source>
        <translation>顶点</translation>
    </message>
    <message>
        <source>it is in another folder</source>
        <translation>它在另一个文件夹里</translation>
    </message>
    <message>
        <source>a mesh</source>
        <translation>网格</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>整数</translation>
    </message>
    <message>
        <source>at least three points</source>
        <translation>至少三个点</translation>
    </message>
    <message>
        <source>simple_polygon or polygon</source>
        <translation>simple_polygon 或 polygon</translation>
    </message>
    <message>
        <source>at least one angle</source>
        <translation>至少一个角度</translation>
    </message>
    <message>
        <source>an instance of strip packing</source>
        <translation>条带排版的题目</translation>
    </message>
    <message>
        <source>at least one item</source>
        <translation>至少一个工件</translation>
    </message>
    <message>
        <source>at least three corners of a face</source>
        <translation>一个面至少三个角</translation>
    </message>
    <message>
        <source>the number of vertices</source>
        <translation>顶点的个数</translation>
    </message>
    <message>
        <source>the number of faces</source>
        <translation>面的个数</translation>
    </message>
    <message>
        <source>the corners of a face</source>
        <translation>面的各个角</translation>
    </message>
    <message>
        <source>pixels</source>
        <translation>像素</translation>
    </message>
    <message>
        <source>the picture is damaged</source>
        <translation>图片已损坏</translation>
    </message>
    <message>
        <source>the rest of the picture</source>
        <translation>图片的其余部分</translation>
    </message>
    <message>
        <source>the picture is damaged here</source>
        <translation>图片在这里损坏</translation>
    </message>
    <message>
        <source>a picture as PNG, JPEG or WebP</source>
        <translation>PNG、JPEG 或 WebP 图片</translation>
    </message>
    <message>
        <source>a picture with at least one pixel</source>
        <translation>至少有一个像素的图片</translation>
    </message>
    <message>
        <source>nothing is writing to this pipe</source>
        <translation>没有程序写入这个管道</translation>
    </message>
    <message>
        <source>nothing came out of it for 10 seconds</source>
        <translation>10 秒内没有任何结果</translation>
    </message>
    <message>
        <source>nothing is reading from this pipe</source>
        <translation>没有程序读取这个管道</translation>
    </message>
    <message>
        <source>the format</source>
        <translation>格式</translation>
    </message>
    <message>
        <source>element or end_header</source>
        <translation>element 或 end_header</translation>
    </message>
    <message>
        <source>ascii or binary</source>
        <translation>ascii 或 binary</translation>
    </message>
    <message>
        <source>a type such as float or int</source>
        <translation>float 或 int 之类的类型</translation>
    </message>
    <message>
        <source>an element first</source>
        <translation>先有一个元素</translation>
    </message>
    <message>
        <source>as many values as the file says it has</source>
        <translation>与文件所写一样多的值</translation>
    </message>
    <message>
        <source>x, y and z</source>
        <translation>x、y 和 z</translation>
    </message>
    <message>
        <source>vertex_indices</source>
        <translation>vertex_indices</translation>
    </message>
    <message>
        <source>the length of a list</source>
        <translation>列表的长度</translation>
    </message>
    <message>
        <source>the disk is full</source>
        <translation>磁盘已满</translation>
    </message>
    <message>
        <source>the number of triangles</source>
        <translation>三角形的个数</translation>
    </message>
    <message>
        <source>as many triangles as the file says it has</source>
        <translation>与文件所写一样多的三角形</translation>
    </message>
    <message>
        <source>facet or endsolid</source>
        <translation>facet 或 endsolid</translation>
    </message>
    <message>
        <source>outer loop</source>
        <translation>outer loop</translation>
    </message>
    <message>
        <source>vertex or endloop</source>
        <translation>vertex 或 endloop</translation>
    </message>
    <message>
        <source>three corners of a triangle</source>
        <translation>三角形的三个角</translation>
    </message>
    <message>
        <source>endfacet</source>
        <translation>endfacet</translation>
    </message>
    <message>
        <source>lines; text must be turned into paths first</source>
        <translation>线条；文字必须先转为路径</translation>
    </message>
    <message>
        <source>lines; a picture must be traced first</source>
        <translation>线条；图片必须先描摹</translation>
    </message>
    <message>
        <source>lines, shapes or paths</source>
        <translation>线、形状或路径</translation>
    </message>
    <message>
        <source>a transform</source>
        <translation>变换</translation>
    </message>
    <message>
        <source>groups in groups</source>
        <translation>组中的组</translation>
    </message>
    <message>
        <source>places within a kilometre</source>
        <translation>一公里以内的位置</translation>
    </message>
    <message>
        <source>pairs of numbers</source>
        <translation>数对</translation>
    </message>
    <message>
        <source>path data</source>
        <translation>路径数据</translation>
    </message>
    <message>
        <source>elements and attributes</source>
        <translation>元素和属性</translation>
    </message>
    <message>
        <source>XML</source>
        <translation>XML</translation>
    </message>
    <message>
        <source>an SVG drawing</source>
        <translation>SVG 图稿</translation>
    </message>
    <message>
        <source>a length</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>points</source>
        <translation>点</translation>
    </message>
    <message>
        <source>a picture or a drawing</source>
        <translation>图片或图稿</translation>
    </message>
    <message>
        <source>there is no 3D model in this file</source>
        <translation>这个文件里没有 3D 模型</translation>
    </message>
    <message>
        <source>a 3D model</source>
        <translation>3D 模型</translation>
    </message>
    <message>
        <source>a unit such as millimeter</source>
        <translation>millimeter 之类的单位</translation>
    </message>
    <message>
        <source>twelve numbers</source>
        <translation>十二个数</translation>
    </message>
    <message>
        <source>an object that does not contain itself</source>
        <translation>不包含自身的对象</translation>
    </message>
    <message numerus="yes">
        <source>%n sections were slightly skewed and have been straightened.</source>
        <translation>
            <numerusform>%n 个插片略有歪斜，已校正。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n contours crossed themselves; the largest loop of each was kept.</source>
        <translation>
            <numerusform>%n 个轮廓与自身交叉；各保留了最大的一圈。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n holes reached beyond their contours and were left out.</source>
        <translation>
            <numerusform>%n 个孔超出了轮廓，已略去。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n holes had no area and were left out.</source>
        <translation>
            <numerusform>%n 个孔没有面积，已略去。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Holes of %n sections overlapped and were merged.</source>
        <translation>
            <numerusform>%n 个插片上的孔重叠，已合并。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n holes reached beyond their contours and were cut out of them.</source>
        <translation>
            <numerusform>%n 个孔超出了轮廓，已从轮廓中切去。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Text after the last section was ignored in %n places.</source>
        <translation>
            <numerusform>最后一个插片之后有 %n 处文字已忽略。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pictures or meshes could not be read and were left out.</source>
        <translation>
            <numerusform>%n 张图片或网格无法读取，已略去。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n templates could not be read; their places were kept.</source>
        <translation>
            <numerusform>%n 个参考物无法读取；保留了它们的位置。</numerusform>
        </translation>
    </message>
    <message>
        <source>the folder cannot be used</source>
        <translation>这个文件夹无法使用</translation>
    </message>
    <message>
        <source>it is open in another window</source>
        <translation>它已在另一个窗口中打开</translation>
    </message>
    <message>
        <source>places where a line may cross itself</source>
        <translation>线条可与自身交叉的位置</translation>
    </message>
    <message>
        <source>its data is damaged</source>
        <translation>它的数据已损坏</translation>
    </message>
    <message>
        <source>a mesh with at least one triangle</source>
        <translation>至少有一个三角形的网格</translation>
    </message>
    <message>
        <source>an edge with three faces or more</source>
        <translation>有三个或更多面的边</translation>
    </message>
    <message>
        <source>a mesh of which two faces meet at an edge</source>
        <translation>每条边只有两个面相接的网格</translation>
    </message>
    <message>
        <source>what was to follow “%1” is a plain number now</source>
        <extracomment>%1 is an expression</extracomment>
        <translation>本该跟随“%1”的数值现在是普通数值</translation>
    </message>
    <message numerus="yes">
        <source>%n numbers no longer follow what was typed for them.</source>
        <translation>
            <numerusform>%n 个数值不再跟随为它们输入的内容。</numerusform>
        </translation>
    </message>
    <message>
        <source>a picture</source>
        <translation>图片</translation>
    </message>
    <message>
        <source>a drawing</source>
        <translation>图稿</translation>
    </message>
    <message>
        <source>each machine once, in their order</source>
        <translation>每台机器一次，按顺序</translation>
    </message>
    <message>
        <source>offcuts</source>
        <translation>余料</translation>
    </message>
    <message>
        <source>an outline from 0, 0 on that does not cross itself</source>
        <translation>从 0, 0 开始且不自交的轮廓线</translation>
    </message>
    <message>
        <source>thicknesses</source>
        <translation>厚度</translation>
    </message>
    <message>
        <source>what a sheet can have</source>
        <translation>板材可以有的值</translation>
    </message>
    <message>
        <source>materials</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>the outline is open: its ends are %1 mm apart</source>
        <translation>轮廓线没有闭合：两端相距 %1 mm</translation>
    </message>
    <message>
        <source>coordinates up to 1e12</source>
        <translation>不超过 1e12 的坐标</translation>
    </message>
    <message>
        <source>placed objects</source>
        <translation>放置的对象</translation>
    </message>
</context>
<context>
    <name>Figure</name>
    <message>
        <source>Circle</source>
        <translation>圆</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>直径</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>椭圆</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>宽度</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高度</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>矩形</translation>
    </message>
    <message>
        <source>Corner radius</source>
        <translation>圆角半径</translation>
    </message>
    <message>
        <source>Polygon</source>
        <translation>多边形</translation>
    </message>
    <message>
        <source>Sides</source>
        <translation>边数</translation>
    </message>
    <message>
        <source>Star</source>
        <translation>星形</translation>
    </message>
    <message>
        <source>Inner diameter</source>
        <translation>内径</translation>
    </message>
    <message>
        <source>Tips</source>
        <translation>角数</translation>
    </message>
    <message>
        <source>Slot</source>
        <translation>长圆形</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>长度</translation>
    </message>
</context>
<context>
    <name>Finding</name>
    <message>
        <source>Cannot be made</source>
        <translation>无法生成</translation>
    </message>
</context>
<context>
    <name>Format</name>
    <message>
        <source>DXF, true to size</source>
        <translation>DXF，实际尺寸</translation>
    </message>
    <message>
        <source>DXF, one for each sheet</source>
        <translation>DXF，每张板材一个</translation>
    </message>
    <message>
        <source>DXF for old programs, R12</source>
        <translation>DXF，用于旧程序，R12</translation>
    </message>
    <message>
        <source>FlatFitFab models</source>
        <translation>FlatFitFab 模型</translation>
    </message>
    <message>
        <source>G-code for GRBL lasers</source>
        <translation>G-code，用于 GRBL 激光机</translation>
    </message>
    <message>
        <source>G-code, one for each sheet</source>
        <translation>G-code，每张板材一个</translation>
    </message>
    <message>
        <source>glTF meshes</source>
        <translation>glTF 网格</translation>
    </message>
    <message>
        <source>LightBurn project</source>
        <translation>LightBurn 项目</translation>
    </message>
    <message>
        <source>LightBurn, one for each sheet</source>
        <translation>LightBurn，每张板材一个</translation>
    </message>
    <message>
        <source>OBJ meshes</source>
        <translation>OBJ 网格</translation>
    </message>
    <message>
        <source>OBJ, solids in place</source>
        <translation>OBJ，原位实体</translation>
    </message>
    <message>
        <source>OBJ, skin as a mesh</source>
        <translation>OBJ，蒙皮网格</translation>
    </message>
    <message>
        <source>OFF meshes</source>
        <translation>OFF 网格</translation>
    </message>
    <message>
        <source>Parts list for spreadsheets</source>
        <translation>零件清单，用于电子表格</translation>
    </message>
    <message>
        <source>PDF, a page for each sheet</source>
        <translation>PDF，每张板材一页</translation>
    </message>
    <message>
        <source>PDF, tiled on A4</source>
        <translation>PDF，分页拼接到 A4</translation>
    </message>
    <message>
        <source>PDF, tiled on Letter</source>
        <translation>PDF，分页拼接到 Letter</translation>
    </message>
    <message>
        <source>PLY meshes</source>
        <translation>PLY 网格</translation>
    </message>
    <message>
        <source>Picture of the sheets</source>
        <translation>板材图片</translation>
    </message>
    <message>
        <source>Pictures, one for each sheet</source>
        <translation>图片，每张板材一张</translation>
    </message>
    <message>
        <source>STL meshes</source>
        <translation>STL 网格</translation>
    </message>
    <message>
        <source>STL, solids in place</source>
        <translation>STL，原位实体</translation>
    </message>
    <message>
        <source>STL, skin as a mesh</source>
        <translation>STL，蒙皮网格</translation>
    </message>
    <message>
        <source>STL, solids lying flat</source>
        <translation>STL，平放实体</translation>
    </message>
    <message>
        <source>SVG, true to size</source>
        <translation>SVG，实际尺寸</translation>
    </message>
    <message>
        <source>SVG, one for each sheet</source>
        <translation>SVG，每张板材一个</translation>
    </message>
    <message>
        <source>3MF meshes</source>
        <translation>3MF 网格</translation>
    </message>
    <message>
        <source>3MF, solids in place</source>
        <translation>3MF，原位实体</translation>
    </message>
    <message>
        <source>3MF, solids lying flat</source>
        <translation>3MF，平放实体</translation>
    </message>
    <message>
        <source>All for the workshop, packed</source>
        <translation>加工全套文件，打包</translation>
    </message>
    <message>
        <source>All for the workshop, in a folder</source>
        <translation>加工全套文件，存入文件夹</translation>
    </message>
</context>
<context>
    <name>FullStop</name>
    <message>
        <source>%1.</source>
        <extracomment>%1 is a sentence; what ends one in this language</extracomment>
        <translation>%1。</translation>
    </message>
</context>
<context>
    <name>Hint</name>
    <message>
        <source>&lt;kbd&gt;%1&lt;/kbd&gt; undoes it.</source>
        <extracomment>%1 is what is pressed; follows &quot;The contour crosses itself; the largest loop was kept.&quot;</extracomment>
        <translation>&lt;kbd&gt;%1&lt;/kbd&gt; 可撤销。</translation>
    </message>
    <message>
        <source>Nothing moved: where %1 and %2 meet, there are no two slits that share the depth.</source>
        <translation>没有移动：%1 和 %2 相交处没有两条共享深度的插槽。</translation>
    </message>
    <message>
        <source>Nothing changed: %1 and %2 cannot be joined like that.</source>
        <translation>没有改动：%1 和 %2 不能那样连接。</translation>
    </message>
    <message>
        <source>Nothing flipped: the slits of %1 and %2 cannot open to the other side.</source>
        <translation>没有翻转：%1 和 %2 的插槽不能朝另一侧开口。</translation>
    </message>
    <message>
        <source>Nothing trimmed: %1 is not in %2, or nothing of it would remain.</source>
        <translation>没有修剪：%1 不在 %2 里面，或者修剪后什么都不剩。</translation>
    </message>
    <message>
        <source>Move to shift the cut, release to leave it there. &lt;kbd&gt;Esc&lt;/kbd&gt; puts it back.</source>
        <translation>移动鼠标平移剖面，松开就停在那里。&lt;kbd&gt;Esc&lt;/kbd&gt; 放回原处。</translation>
    </message>
    <message>
        <source>You can&apos;t draw on a plane seen edge-on: turn the view to go on.</source>
        <translation>平面正好侧对着你，没法画：请先转动视图再继续。</translation>
    </message>
    <message>
        <source>Path discarded: its section no longer exists.</source>
        <translation>路径已丢弃：它的插片已不存在。</translation>
    </message>
    <message>
        <source>Nothing drawn: no section can be made from this line. Draw it as one open loop.</source>
        <translation>没画成：这条线生成不了插片。请画成一个开口的圈。</translation>
    </message>
    <message>
        <source>Nothing drawn: all of it lies below the ground, where it is cut off.</source>
        <translation>没画成：全都在地面以下，会被切掉。</translation>
    </message>
    <message>
        <source>No hole made: it must lie in %1 and leave it in one piece.</source>
        <translation>没开孔：孔必须在 %1 内，并且不能把它切断。</translation>
    </message>
    <message>
        <source>The hole reaches beyond the edge of %1 and was cut out of it.</source>
        <translation>孔超出了 %1 的边缘，已从它上面切去。</translation>
    </message>
    <message>
        <source>The hole touched others in %1; they are one hole now.</source>
        <translation>这个孔碰到了 %1 上别的孔；它们现在合成一个孔。</translation>
    </message>
    <message>
        <source>Holes of %1 outside its new contour were left out.</source>
        <translation>%1 在新轮廓之外的孔已略去。</translation>
    </message>
    <message>
        <source>Draw a section on the ground in one go. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>在地面上一笔画出一个插片。&lt;kbd&gt;Esc&lt;/kbd&gt; 取消。</translation>
    </message>
    <message>
        <source>Draw a section on the front plane in one go. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>在前平面上一笔画出一个插片。&lt;kbd&gt;Esc&lt;/kbd&gt; 取消。</translation>
    </message>
    <message>
        <source>Draw a section on the side plane in one go. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>在侧平面上一笔画出一个插片。&lt;kbd&gt;Esc&lt;/kbd&gt; 取消。</translation>
    </message>
    <message>
        <source>Draw a section parallel to %1 in one go. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>一笔画出一个与 %1 平行的插片。&lt;kbd&gt;Esc&lt;/kbd&gt; 取消。</translation>
    </message>
    <message>
        <source>Draw the new contour of %1 in one go. &lt;kbd&gt;Esc&lt;/kbd&gt; keeps the old one.</source>
        <translation>一笔画出 %1 的新轮廓。&lt;kbd&gt;Esc&lt;/kbd&gt; 保留旧轮廓。</translation>
    </message>
    <message>
        <source>Draw a hole in %1 in one go. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>在 %1 上一笔画出一个孔。&lt;kbd&gt;Esc&lt;/kbd&gt; 取消。</translation>
    </message>
    <message>
        <source>Draw a hole: begin on the section that gets it. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>画孔：从要开孔的插片上开始。&lt;kbd&gt;Esc&lt;/kbd&gt; 取消。</translation>
    </message>
    <message>
        <source>Nothing imported: no line in %1 forms a closed outline. They can be engraved.</source>
        <translation>没有导入：%1 中没有线构成闭合的轮廓线。它们可以用来雕刻。</translation>
    </message>
    <message numerus="yes">
        <source>%n outlines of %1 did not fit and were left out.</source>
        <translation>
            <numerusform>%1 中有 %n 条轮廓线不合适，已略去。</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2 skipped; %3.</source>
        <extracomment>%1 is a file, %2 &quot;3 texts&quot;, %3 &quot;5 lines were read&quot;</extracomment>
        <translation>%1：跳过 %2；%3。</translation>
    </message>
    <message>
        <source>%1: %2 and %3 skipped; %4.</source>
        <extracomment>%1 is a file, %2 &quot;3 texts&quot;, %3 &quot;1 picture&quot;, %4 &quot;5 lines were read&quot;</extracomment>
        <translation>%1：跳过 %2和 %3；%4。</translation>
    </message>
    <message numerus="yes">
        <source>%n texts</source>
        <translation>
            <numerusform>%n 段文字</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pictures</source>
        <translation>
            <numerusform>%n 张图片</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n lines were read</source>
        <translation>
            <numerusform>读入 %n 条线</numerusform>
        </translation>
    </message>
    <message>
        <source>%2 lies aslant to %1: move it to the plane of %1 first.</source>
        <extracomment>%1 is a section, %2 the name of a template</extracomment>
        <translation>%2 与 %1 不平行：请先把它移到 %1 的平面上。</translation>
    </message>
    <message numerus="yes">
        <source>%1 has %n outlines, which is too many: trace it coarser, or smooth it first.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>
            <numerusform>%1 有 %n 条轮廓线，太多了：请描摹得粗一些，或先做平滑。</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing traced: no part of %1 is on that side of the threshold.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>没有描摹：%1 没有任何部分在阈值的那一侧。</translation>
    </message>
    <message>
        <source>%1: drag outwards from its centre; a click makes one of the usual size.</source>
        <extracomment>%1 is a shape (&quot;Circle&quot;)</extracomment>
        <translation>%1：从中心向外拖；点击则生成常用大小。</translation>
    </message>
    <message>
        <source>%1: drag outwards from its centre to cut it out of %2.</source>
        <extracomment>%1 is a shape (&quot;Circle&quot;), %2 the name of a section</extracomment>
        <translation>%1：从中心向外拖，从 %2 上切出它。</translation>
    </message>
    <message>
        <source>Release to make it this size; &lt;kbd&gt;Shift&lt;/kbd&gt; keeps both sides equal. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>松开就是这个大小；&lt;kbd&gt;Shift&lt;/kbd&gt; 让两边相等。&lt;kbd&gt;Esc&lt;/kbd&gt; 取消。</translation>
    </message>
    <message>
        <source>Draw the first section: press, draw its shape in one go, release.</source>
        <translation>画第一个插片：按下，一笔画出形状，松开。</translation>
    </message>
    <message>
        <source>Drag to turn the view; &lt;kbd&gt;Shift&lt;/kbd&gt; drag selects a group.</source>
        <translation>拖动转动视图；按住 &lt;kbd&gt;Shift&lt;/kbd&gt; 拖动框选。</translation>
    </message>
    <message>
        <source>Drag out of %1 to draw a section across it; click to select it.</source>
        <translation>从 %1 里向外拖，画一个横穿它的插片；点击选中它。</translation>
    </message>
    <message>
        <source>Click to select %1. Drag to turn the view: you can&apos;t draw on a section seen edge-on.</source>
        <translation>点击选中 %1。拖动转动视图：侧对着你的插片上没法画。</translation>
    </message>
    <message>
        <source>Drag to move the cut through the model; &lt;kbd&gt;Esc&lt;/kbd&gt; closes it.</source>
        <translation>拖动让剖面在模型中移动；&lt;kbd&gt;Esc&lt;/kbd&gt; 关闭它。</translation>
    </message>
    <message>
        <source>Click to select problem %1.</source>
        <translation>点击选中问题 %1。</translation>
    </message>
    <message>
        <source>Drag to move the point; &lt;kbd&gt;Ctrl&lt;/kbd&gt; makes a corner, arrow keys move 1&#x202f;mm.</source>
        <translation>拖动移动这个点；&lt;kbd&gt;Ctrl&lt;/kbd&gt; 变成角点，方向键移动 1&#x202f;mm。</translation>
    </message>
    <message>
        <source>Drag to bend the curve; &lt;kbd&gt;Ctrl&lt;/kbd&gt; makes a corner, &lt;kbd&gt;Shift&lt;/kbd&gt; keeps the direction.</source>
        <translation>拖动弯曲曲线；&lt;kbd&gt;Ctrl&lt;/kbd&gt; 变成角点，&lt;kbd&gt;Shift&lt;/kbd&gt; 保持方向。</translation>
    </message>
    <message>
        <source>Double-click to add a point here; drag to bend the contour.</source>
        <translation>双击在这里加一个点；拖动弯曲轮廓。</translation>
    </message>
    <message>
        <source>Click to select the joint of %1 and %2.</source>
        <translation>点击选中 %1 和 %2 的接头。</translation>
    </message>
    <message>
        <source>Drag to make the slit of %1 deeper and that of %2 shallower; click to select the joint.</source>
        <translation>拖动让 %1 的插槽变深、%2 的变浅；点击选中这个接头。</translation>
    </message>
    <message>
        <source>Drag to make the slit of %1 deeper and that of %2 shallower; arrow keys move 1&#x202f;mm.</source>
        <translation>拖动让 %1 的插槽变深、%2 的变浅；方向键移动 1&#x202f;mm。</translation>
    </message>
    <message>
        <source>Drag to move the weight of %1 on %2; click to select it.</source>
        <translation>拖动移动 %2 上 %1 的重物；点击选中它。</translation>
    </message>
    <message>
        <source>Arrow keys move the weight of %1 on %2 by 1&#x202f;mm; &lt;kbd&gt;+&lt;/kbd&gt; and &lt;kbd&gt;−&lt;/kbd&gt; change it, &lt;kbd&gt;Del&lt;/kbd&gt; removes it.</source>
        <translation>方向键把 %2 上 %1 的重物移动 1&#x202f;mm；&lt;kbd&gt;+&lt;/kbd&gt; 和 &lt;kbd&gt;−&lt;/kbd&gt; 改变它，&lt;kbd&gt;Del&lt;/kbd&gt; 移除它。</translation>
    </message>
    <message>
        <source>Drag to move the push of %1 on %2, its tip to turn it; click to select it.</source>
        <translation>拖动移动 %2 上 %1 的推力，拖动箭头尖可转动它；点击选中它。</translation>
    </message>
    <message>
        <source>Arrow keys move the push of %1 on %2 by 1&#x202f;mm; &lt;kbd&gt;+&lt;/kbd&gt; and &lt;kbd&gt;−&lt;/kbd&gt; change it, &lt;kbd&gt;Del&lt;/kbd&gt; removes it.</source>
        <translation>方向键把 %2 上 %1 的推力移动 1&#x202f;mm；&lt;kbd&gt;+&lt;/kbd&gt; 和 &lt;kbd&gt;−&lt;/kbd&gt; 改变它，&lt;kbd&gt;Del&lt;/kbd&gt; 移除它。</translation>
    </message>
    <message>
        <source>%1 is made by %2: click to edit them all, click again for this one.</source>
        <translation>%1 由 %2 生成：点击编辑全部，再点击只选这一个。</translation>
    </message>
    <message>
        <source>Click to select %1 alone; drag out of it to draw a section across it.</source>
        <translation>点击只选中 %1；从它里面向外拖，画一个横穿它的插片。</translation>
    </message>
    <message>
        <source>Drag a round handle to move the start or the end of %1; click one section to select it.</source>
        <translation>拖动圆形手柄移动 %1 的起点或终点；点击一个插片选中它。</translation>
    </message>
    <message>
        <source>Drag to move the start of %1; click to type it.</source>
        <translation>拖动移动 %1 的起点；点击可输入数字。</translation>
    </message>
    <message>
        <source>Drag to move the end of %1; click to type it.</source>
        <translation>拖动移动 %1 的终点；点击可输入数字。</translation>
    </message>
    <message>
        <source>Click to look from the front; drag to turn the view.</source>
        <translation>点击从前面看；拖动转动视图。</translation>
    </message>
    <message>
        <source>Click to look from the back; drag to turn the view.</source>
        <translation>点击从后面看；拖动转动视图。</translation>
    </message>
    <message>
        <source>Click to look from the left; drag to turn the view.</source>
        <translation>点击从左面看；拖动转动视图。</translation>
    </message>
    <message>
        <source>Click to look from the right; drag to turn the view.</source>
        <translation>点击从右面看；拖动转动视图。</translation>
    </message>
    <message>
        <source>Click to look from the top; drag to turn the view.</source>
        <translation>点击从上面看；拖动转动视图。</translation>
    </message>
    <message>
        <source>Click to look from below; drag to turn the view.</source>
        <translation>点击从下面看；拖动转动视图。</translation>
    </message>
    <message>
        <source>Click to look at this edge; drag to turn the view.</source>
        <translation>点击正对这条边看；拖动转动视图。</translation>
    </message>
    <message>
        <source>Click to look at this corner; drag to turn the view.</source>
        <translation>点击正对这个角看；拖动转动视图。</translation>
    </message>
    <message>
        <source>Drag to turn the view; the wheel zooms.</source>
        <translation>拖动转动视图；滚轮缩放。</translation>
    </message>
    <message>
        <source>Release to leave it here: the slit of %1 takes %2&#x202f;%. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>松开就停在这里：%1 的插槽占 %2&#x202f;%。&lt;kbd&gt;Esc&lt;/kbd&gt; 取消。</translation>
    </message>
    <message>
        <source>Click a place on a section to put %1 there. &lt;kbd&gt;Esc&lt;/kbd&gt; ends.</source>
        <translation>点击插片上的一处，把 %1 放在那里。&lt;kbd&gt;Esc&lt;/kbd&gt; 结束。</translation>
    </message>
    <message>
        <source>Press on a section and drag in the direction of the push. &lt;kbd&gt;Esc&lt;/kbd&gt; ends.</source>
        <translation>按住一个插片，朝要推的方向拖动。&lt;kbd&gt;Esc&lt;/kbd&gt; 结束。</translation>
    </message>
    <message>
        <source>Press on a section and drag to pull it and see what happens; nothing is kept.</source>
        <translation>按住一个插片拉动它，看会发生什么；结果不保留。</translation>
    </message>
    <message>
        <source>Release to let it go: nothing is kept.</source>
        <translation>松开就放手：什么都不保留。</translation>
    </message>
    <message>
        <source>Drag to move it. &lt;b&gt;Click&lt;/b&gt; selects it.</source>
        <translation>拖动移动它。&lt;b&gt;点击&lt;/b&gt;选中它。</translation>
    </message>
    <message>
        <source>Drag the tip to turn the push; a longer arrow pushes harder.</source>
        <translation>拖动箭头尖转动推力；箭头越长，推得越用力。</translation>
    </message>
    <message>
        <source>Release to put the weight here. &lt;kbd&gt;Esc&lt;/kbd&gt; puts it back.</source>
        <translation>松开就把重物放在这里。&lt;kbd&gt;Esc&lt;/kbd&gt; 放回原处。</translation>
    </message>
    <message>
        <source>Release to push here. &lt;kbd&gt;Esc&lt;/kbd&gt; puts it back.</source>
        <translation>松开就推这里。&lt;kbd&gt;Esc&lt;/kbd&gt; 放回原处。</translation>
    </message>
    <message>
        <source>No weight added: click on a section.</source>
        <translation>没有添加重物：请点击一个插片。</translation>
    </message>
    <message>
        <source>No push added: press on a section.</source>
        <translation>没有添加推力：请按在一个插片上。</translation>
    </message>
    <message>
        <source>The copy of %1 carries it too; &lt;i&gt;Properties&lt;/i&gt; can keep it to this one.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 的副本也承载它；可在&lt;i&gt;属性&lt;/i&gt;中设为只加在这一个上。</translation>
    </message>
    <message numerus="yes">
        <source>%n copies of %1 carry it too; &lt;i&gt;Properties&lt;/i&gt; can keep it to this one.</source>
        <translation>
            <numerusform>%1 的 %n 个副本也承载它；可在&lt;i&gt;属性&lt;/i&gt;中设为只加在这一个上。</numerusform>
        </translation>
    </message>
    <message>
        <source>The weight stays where it is: there it would be off %1.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>重物留在原处：移到那里就不在 %1 上了。</translation>
    </message>
    <message>
        <source>The push stays where it is: there it would be off %1.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>推力留在原处：移到那里就不在 %1 上了。</translation>
    </message>
    <message>
        <source>Drag to set how far %1 pulls templates.</source>
        <translation>拖动设定 %1 磁吸参考物的距离。</translation>
    </message>
    <message>
        <source>Release to let %1 pull templates from %2. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <extracomment>%1 is the name of a section, %2 a length</extracomment>
        <translation>松开让 %1 磁吸 %2 以内的参考物。&lt;kbd&gt;Esc&lt;/kbd&gt; 取消。</translation>
    </message>
    <message>
        <source>Draw on the section to engrave, or click it. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>在要雕刻的插片上画，或点击它。&lt;kbd&gt;Esc&lt;/kbd&gt; 取消。</translation>
    </message>
    <message>
        <source>Drag to draw a line on %1; &lt;kbd&gt;Shift&lt;/kbd&gt; keeps it straight. Click to place text.</source>
        <translation>拖动在 %1 上画线；&lt;kbd&gt;Shift&lt;/kbd&gt; 保持直线。点击放置文字。</translation>
    </message>
    <message>
        <source>Release to keep the line. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>松开保留这条线。&lt;kbd&gt;Esc&lt;/kbd&gt; 取消。</translation>
    </message>
    <message>
        <source>%1 is engraved on its front, the one face that the laser reaches; the view has turned to it.</source>
        <extracomment>%1 is the name of a section, seen from behind until now</extracomment>
        <translation>%1 雕刻在正面，激光只能照到这一面；视图已转到这一面。</translation>
    </message>
    <message>
        <source>Nothing engraved: that is not on %1.</source>
        <translation>没有雕刻：那里不在 %1 上。</translation>
    </message>
    <message>
        <source>The character “%1” cannot be engraved.</source>
        <translation>字符“%1”无法雕刻。</translation>
    </message>
    <message>
        <source>Drag from one place to another to measure; &lt;kbd&gt;Ctrl&lt;/kbd&gt; turns snapping off. &lt;kbd&gt;Esc&lt;/kbd&gt; ends.</source>
        <translation>从一处拖到另一处来测量；&lt;kbd&gt;Ctrl&lt;/kbd&gt; 不吸附。&lt;kbd&gt;Esc&lt;/kbd&gt; 结束。</translation>
    </message>
    <message>
        <source>Move to the second place. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>移到第二处。&lt;kbd&gt;Esc&lt;/kbd&gt; 取消。</translation>
    </message>
    <message>
        <source>Click or drag to measure again. &lt;kbd&gt;Esc&lt;/kbd&gt; clears it.</source>
        <translation>点击或拖动重新测量。&lt;kbd&gt;Esc&lt;/kbd&gt; 清除。</translation>
    </message>
    <message>
        <source>Drag along something whose length you know; the whole model follows. &lt;kbd&gt;Esc&lt;/kbd&gt; ends.</source>
        <translation>沿着已知长度的地方拖动；整个模型随之缩放。&lt;kbd&gt;Esc&lt;/kbd&gt; 结束。</translation>
    </message>
    <message>
        <source>Type the length you want; &lt;kbd&gt;Enter&lt;/kbd&gt; scales the whole model. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>输入想要的长度；&lt;kbd&gt;Enter&lt;/kbd&gt; 缩放整个模型。&lt;kbd&gt;Esc&lt;/kbd&gt; 取消。</translation>
    </message>
    <message>
        <source>The model cannot be made that large or small.</source>
        <translation>模型不能变得那么大或那么小。</translation>
    </message>
    <message>
        <source>The model cannot be scaled that far: %1 would go beyond its limits.</source>
        <translation>模型不能缩放那么多：%1 会超出限度。</translation>
    </message>
    <message>
        <source>Click the section to mirror across; drag to turn the view. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>点击作为镜面的插片；拖动转动视图。&lt;kbd&gt;Esc&lt;/kbd&gt; 取消。</translation>
    </message>
    <message>
        <source>B: make it a circle</source>
        <translation>B：变成圆</translation>
    </message>
    <message>
        <source>B: make it an ellipse</source>
        <translation>B：变成椭圆</translation>
    </message>
    <message>
        <source>B: make its lines straight</source>
        <translation>B：把线变直</translation>
    </message>
    <message>
        <source>B: square the corners</source>
        <translation>B：把角变成直角</translation>
    </message>
    <message>
        <source>B: move its slit in from the edge</source>
        <translation>B：把插槽从边缘往里移</translation>
    </message>
    <message>
        <source>Made it a circle.</source>
        <translation>已变成圆。</translation>
    </message>
    <message>
        <source>Made it an ellipse.</source>
        <translation>已变成椭圆。</translation>
    </message>
    <message>
        <source>Lines straightened.</source>
        <translation>线已变直。</translation>
    </message>
    <message>
        <source>Corners squared.</source>
        <translation>角已变成直角。</translation>
    </message>
    <message>
        <source>Moved in from the edge.</source>
        <translation>已从边缘往里移。</translation>
    </message>
    <message>
        <source>%1 stays where it was drawn: moved in, its slit would cut up %2. Draw across the edge, not along it.</source>
        <extracomment>%1 and %2 are names of sections</extracomment>
        <translation>%1 留在画它的地方：往里移的话，它的插槽会把 %2 切碎。请横穿边缘画，不要沿着边缘画。</translation>
    </message>
    <message>
        <source>Release to start %1 here: %2&#x202f;%. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <extracomment>%1 is the name of an operation, %2 a number</extracomment>
        <translation>松开让 %1 从这里开始：%2&#x202f;%。&lt;kbd&gt;Esc&lt;/kbd&gt; 取消。</translation>
    </message>
    <message>
        <source>Release to end %1 here: %2&#x202f;%. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <extracomment>%1 is the name of an operation, %2 a number</extracomment>
        <translation>松开让 %1 到这里结束：%2&#x202f;%。&lt;kbd&gt;Esc&lt;/kbd&gt; 取消。</translation>
    </message>
    <message>
        <source>Drag out of a section to draw across it with the pen; drag here to turn the view. &lt;kbd&gt;Esc&lt;/kbd&gt; puts the pen away.</source>
        <translation>从插片里向外拖，用钢笔画横穿它的插片；在这里拖动转动视图。&lt;kbd&gt;Esc&lt;/kbd&gt; 收起钢笔。</translation>
    </message>
    <message>
        <source>Drag out of %1 to draw across it with the pen; click to select it.</source>
        <translation>从 %1 里向外拖，用钢笔画横穿它的插片；点击选中它。</translation>
    </message>
    <message>
        <source>Click to set the first point, drag to bend. &lt;kbd&gt;Esc&lt;/kbd&gt; puts the pen away.</source>
        <translation>点击放第一个点，拖动弯曲。&lt;kbd&gt;Esc&lt;/kbd&gt; 收起钢笔。</translation>
    </message>
    <message>
        <source>Click to set a point, drag to bend; &lt;kbd&gt;Enter&lt;/kbd&gt; closes, &lt;kbd&gt;Backspace&lt;/kbd&gt; takes one back.</source>
        <translation>点击放点，拖动弯曲；&lt;kbd&gt;Enter&lt;/kbd&gt; 闭合，&lt;kbd&gt;Backspace&lt;/kbd&gt; 退回一个点。</translation>
    </message>
    <message>
        <source>Click to set a point, drag to bend; &lt;kbd&gt;Enter&lt;/kbd&gt; closes, &lt;kbd&gt;Backspace&lt;/kbd&gt; takes one back. &lt;kbd&gt;Ctrl&lt;/kbd&gt;+click sets it without snapping.</source>
        <translation>点击放点，拖动弯曲；&lt;kbd&gt;Enter&lt;/kbd&gt; 闭合，&lt;kbd&gt;Backspace&lt;/kbd&gt; 退回一个点。按住 &lt;kbd&gt;Ctrl&lt;/kbd&gt; 点击不吸附。</translation>
    </message>
    <message>
        <source>The contour crosses itself: &lt;kbd&gt;Enter&lt;/kbd&gt; keeps the largest loop, &lt;kbd&gt;Backspace&lt;/kbd&gt; takes a point back.</source>
        <translation>轮廓与自身交叉：&lt;kbd&gt;Enter&lt;/kbd&gt; 保留最大的一圈，&lt;kbd&gt;Backspace&lt;/kbd&gt; 退回一个点。</translation>
    </message>
    <message>
        <source>Drag to bend; &lt;kbd&gt;Ctrl&lt;/kbd&gt; makes a corner, &lt;kbd&gt;Shift&lt;/kbd&gt; holds the direction.</source>
        <translation>拖动弯曲；&lt;kbd&gt;Ctrl&lt;/kbd&gt; 变成角点，&lt;kbd&gt;Shift&lt;/kbd&gt; 保持方向。</translation>
    </message>
    <message>
        <source>Drag to move the point; &lt;kbd&gt;Ctrl&lt;/kbd&gt; turns snapping off, &lt;kbd&gt;Shift&lt;/kbd&gt; holds the direction.</source>
        <translation>拖动移动这个点；&lt;kbd&gt;Ctrl&lt;/kbd&gt; 不吸附，&lt;kbd&gt;Shift&lt;/kbd&gt; 保持方向。</translation>
    </message>
    <message>
        <source>Drag the handle to bend; &lt;kbd&gt;Ctrl&lt;/kbd&gt; makes a corner.</source>
        <translation>拖动手柄弯曲；&lt;kbd&gt;Ctrl&lt;/kbd&gt; 变成角点。</translation>
    </message>
    <message>
        <source>Click to close the contour; drag to move the point.</source>
        <translation>点击闭合轮廓；拖动移动这个点。</translation>
    </message>
    <message>
        <source>&lt;kbd&gt;Enter&lt;/kbd&gt; sets the point, &lt;kbd&gt;Tab&lt;/kbd&gt; goes to the next number. &lt;kbd&gt;Esc&lt;/kbd&gt; closes the bar.</source>
        <translation>&lt;kbd&gt;Enter&lt;/kbd&gt; 放置这个点，&lt;kbd&gt;Tab&lt;/kbd&gt; 转到下一个数字。&lt;kbd&gt;Esc&lt;/kbd&gt; 关闭输入栏。</translation>
    </message>
    <message>
        <source>Not closed: the points enclose nothing yet.</source>
        <translation>没有闭合：这些点还围不成任何东西。</translation>
    </message>
    <message>
        <source>A contour is still open: &lt;kbd&gt;Enter&lt;/kbd&gt; closes it, &lt;kbd&gt;Esc&lt;/kbd&gt; takes it back.</source>
        <translation>还有轮廓没闭合：&lt;kbd&gt;Enter&lt;/kbd&gt; 闭合它，&lt;kbd&gt;Esc&lt;/kbd&gt; 取消它。</translation>
    </message>
    <message>
        <source>%1 &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <extracomment>%1 is a sentence: &quot;Click the section to repeat.&quot;</extracomment>
        <translation>%1&lt;kbd&gt;Esc&lt;/kbd&gt; 取消。</translation>
    </message>
    <message>
        <source>%1 So far: %2. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <extracomment>%1 is a sentence, %2 a number of sections</extracomment>
        <translation>%1目前：%2。&lt;kbd&gt;Esc&lt;/kbd&gt; 取消。</translation>
    </message>
    <message>
        <source>%1 So far: %2. &lt;kbd&gt;Enter&lt;/kbd&gt; makes it.</source>
        <extracomment>%1 is a sentence, %2 a number of sections</extracomment>
        <translation>%1目前：%2。&lt;kbd&gt;Enter&lt;/kbd&gt; 生成。</translation>
    </message>
    <message>
        <source>&lt;kbd&gt;Enter&lt;/kbd&gt; makes it. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>&lt;kbd&gt;Enter&lt;/kbd&gt; 生成。&lt;kbd&gt;Esc&lt;/kbd&gt; 取消。</translation>
    </message>
    <message>
        <source>Release to leave it here. &lt;kbd&gt;Ctrl&lt;/kbd&gt; makes a corner, &lt;kbd&gt;Shift&lt;/kbd&gt; keeps the direction.</source>
        <translation>松开就停在这里。&lt;kbd&gt;Ctrl&lt;/kbd&gt; 变成角点，&lt;kbd&gt;Shift&lt;/kbd&gt; 保持方向。</translation>
    </message>
    <message>
        <source>Release to keep it like this. &lt;kbd&gt;Ctrl&lt;/kbd&gt; makes a corner, &lt;kbd&gt;Shift&lt;/kbd&gt; keeps the direction.</source>
        <translation>松开就保持这样。&lt;kbd&gt;Ctrl&lt;/kbd&gt; 变成角点，&lt;kbd&gt;Shift&lt;/kbd&gt; 保持方向。</translation>
    </message>
    <message>
        <source>Release to keep it like this. &lt;kbd&gt;Ctrl&lt;/kbd&gt; makes corners at its ends. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>松开就保持这样。&lt;kbd&gt;Ctrl&lt;/kbd&gt; 把两端变成角点。&lt;kbd&gt;Esc&lt;/kbd&gt; 取消。</translation>
    </message>
    <message>
        <source>The contour would cross itself here; it stays as it was just before.</source>
        <translation>轮廓在这里会与自身交叉；它保持刚才的样子。</translation>
    </message>
    <message>
        <source>A hole would touch the edge or another hole here; it stays as it was just before.</source>
        <translation>孔在这里会碰到边缘或另一个孔；它保持刚才的样子。</translation>
    </message>
    <message>
        <source>All of %1 would be cut off at the ground here; it stays as it was.</source>
        <translation>在这里 %1 会整个被地面切掉；它保持原样。</translation>
    </message>
    <message>
        <source>Nothing deleted: a contour needs at least two points.</source>
        <translation>没有删除：轮廓至少需要两个点。</translation>
    </message>
    <message>
        <source>Release to select everything that is completely inside. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>松开选中完全在框内的所有内容。&lt;kbd&gt;Esc&lt;/kbd&gt; 取消。</translation>
    </message>
    <message>
        <source>Release to select the points inside. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>松开选中框内的点。&lt;kbd&gt;Esc&lt;/kbd&gt; 取消。</translation>
    </message>
    <message>
        <source>%1 keeps its angle to %2. Free it to turn it as you like.</source>
        <translation>%1 与 %2 保持角度。让它脱离后，就能随意转动。</translation>
    </message>
    <message>
        <source>%1 is not on another section, so it has no angle to one.</source>
        <translation>%1 不在别的插片上，所以没有与之相对的角度。</translation>
    </message>
    <message>
        <source>%1 cannot be on %2, which is on it.</source>
        <translation>%1 不能放在 %2 上，因为 %2 就在它上面。</translation>
    </message>
    <message>
        <source>%1 and %2 do not meet: move one of them across the other first.</source>
        <translation>%1 和 %2 没有相交：请先移动其中一个，让它横穿另一个。</translation>
    </message>
    <message>
        <source>Click the section to put %1 on. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>点击要把 %1 放到哪个插片上。&lt;kbd&gt;Esc&lt;/kbd&gt; 取消。</translation>
    </message>
    <message>
        <source>Drag to turn the view; &lt;kbd&gt;Space&lt;/kbd&gt; plays, &lt;kbd&gt;←&lt;/kbd&gt; and &lt;kbd&gt;→&lt;/kbd&gt; go step by step. &lt;kbd&gt;Esc&lt;/kbd&gt; closes the steps.</source>
        <translation>拖动转动视图；&lt;kbd&gt;空格&lt;/kbd&gt; 播放，&lt;kbd&gt;←&lt;/kbd&gt; 和 &lt;kbd&gt;→&lt;/kbd&gt; 逐步查看。&lt;kbd&gt;Esc&lt;/kbd&gt; 关闭步骤。</translation>
    </message>
    <message>
        <source>The model has changed, so the view of its steps was closed.</source>
        <translation>模型已改动，所以关闭了步骤视图。</translation>
    </message>
    <message>
        <source>Drag on to leave %1; the slit ends at its edge. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>继续拖出 %1；插槽在它的边缘结束。&lt;kbd&gt;Esc&lt;/kbd&gt; 取消。</translation>
    </message>
    <message>
        <source>Drag on to leave %1. &lt;kbd&gt;Ctrl&lt;/kbd&gt; leaves the slit as you draw it. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>继续拖出 %1。&lt;kbd&gt;Ctrl&lt;/kbd&gt; 让插槽保持你画的样子。&lt;kbd&gt;Esc&lt;/kbd&gt; 取消。</translation>
    </message>
    <message>
        <source>The view is turning: draw on at once, or wait until it stops.</source>
        <translation>视图正在转动：可以马上接着画，也可以等它停下。</translation>
    </message>
    <message>
        <source>Draw the outline: leave the grey zone where it should start. Release here to cancel.</source>
        <translation>画出轮廓：从想开始的地方离开灰色区域。在这里松开则取消。</translation>
    </message>
    <message>
        <source>Draw the contour, release to close it. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>画出轮廓，松开即闭合。&lt;kbd&gt;Esc&lt;/kbd&gt; 取消。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to make the section. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>&lt;b&gt;松开&lt;/b&gt;即生成插片。&lt;kbd&gt;Esc&lt;/kbd&gt; 取消。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to cut the hole into %1. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>&lt;b&gt;松开&lt;/b&gt;即在 %1 上开孔。&lt;kbd&gt;Esc&lt;/kbd&gt; 取消。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to give %1 this contour. &lt;kbd&gt;Esc&lt;/kbd&gt; keeps the old one.</source>
        <translation>&lt;b&gt;松开&lt;/b&gt;即让 %1 采用这个轮廓。&lt;kbd&gt;Esc&lt;/kbd&gt; 保留旧轮廓。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to make the section, mirrored across the slit. Hold &lt;kbd&gt;Shift&lt;/kbd&gt; to keep only this side. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>&lt;b&gt;松开&lt;/b&gt;即生成沿插槽镜像的插片。按住 &lt;kbd&gt;Shift&lt;/kbd&gt; 只保留这一侧。&lt;kbd&gt;Esc&lt;/kbd&gt; 取消。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to make the section, mirrored. Let &lt;kbd&gt;Shift&lt;/kbd&gt; go to keep only this side. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>&lt;b&gt;松开&lt;/b&gt;即生成镜像的插片。放开 &lt;kbd&gt;Shift&lt;/kbd&gt; 只保留这一侧。&lt;kbd&gt;Esc&lt;/kbd&gt; 取消。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to give %1 this contour, mirrored across its slit. &lt;kbd&gt;Shift&lt;/kbd&gt; does the opposite.</source>
        <translation>&lt;b&gt;松开&lt;/b&gt;即让 %1 采用这个沿插槽镜像的轮廓。&lt;kbd&gt;Shift&lt;/kbd&gt; 则相反。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Release&lt;/b&gt; to make the section, mirrored across the vertical. Hold &lt;kbd&gt;Shift&lt;/kbd&gt; to keep only this side.</source>
        <translation>&lt;b&gt;松开&lt;/b&gt;即生成沿竖直线镜像的插片。按住 &lt;kbd&gt;Shift&lt;/kbd&gt; 只保留这一侧。</translation>
    </message>
    <message>
        <source>Follow the teal curve to snap to %1; hold &lt;kbd&gt;Ctrl&lt;/kbd&gt; to leave it. &lt;kbd&gt;Shift+Enter&lt;/kbd&gt; takes it whole.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>沿着青色曲线画会吸附到 %1；按住 &lt;kbd&gt;Ctrl&lt;/kbd&gt; 可离开它。&lt;kbd&gt;Shift+Enter&lt;/kbd&gt; 采用整条曲线。</translation>
    </message>
    <message>
        <source>Shift+Enter: take the whole guide</source>
        <translation>Shift+Enter：采用整条引导线</translation>
    </message>
    <message>
        <source>The slit does not touch a guide, so there is none to take whole.</source>
        <translation>插槽没有碰到引导线，所以没有可整条采用的。</translation>
    </message>
    <message>
        <source>Nothing drawn: the slit never left %1. Start inside and drag across its edge; &lt;kbd&gt;O&lt;/kbd&gt; draws holes, &lt;kbd&gt;E&lt;/kbd&gt; engraves.</source>
        <translation>没画成：插槽一直没有离开 %1。请从里面开始，拖过它的边缘；&lt;kbd&gt;O&lt;/kbd&gt; 画孔，&lt;kbd&gt;E&lt;/kbd&gt; 雕刻。</translation>
    </message>
    <message>
        <source>Nothing drawn: the line is too short to enclose anything.</source>
        <translation>没画成：线太短，围不成任何东西。</translation>
    </message>
    <message>
        <source>Nothing drawn: a line of less than %1 is taken for a slip of the hand, unless it closes a loop.</source>
        <extracomment>%1 is a length</extracomment>
        <translation>没画成：短于 %1 的线会当作手滑，除非它围成一圈。</translation>
    </message>
    <message>
        <source>Nothing drawn: the line goes there and back and encloses nothing.</source>
        <translation>没画成：线走过去又原路返回，围不成任何东西。</translation>
    </message>
    <message>
        <source>Nothing drawn: the line crosses itself, and no loop of it is large enough.</source>
        <translation>没画成：线与自身交叉，而且没有一圈足够大。</translation>
    </message>
    <message>
        <source>%1 was not mirrored: the two halves would not meet.</source>
        <translation>%1 没有镜像：两半接不上。</translation>
    </message>
    <message>
        <source>The contour crosses itself; the largest loop was kept.</source>
        <translation>轮廓与自身交叉；保留了最大的一圈。</translation>
    </message>
    <message>
        <source>%1 was mirrored; what crossed its axis and came back was left out.</source>
        <translation>%1 已镜像；越过对称轴又折回的部分已略去。</translation>
    </message>
    <message>
        <source>%1 does not reach its slit: nothing joins it to %2.</source>
        <extracomment>%2 is the section that the slit is in</extracomment>
        <translation>%1 够不到自己的插槽：没有东西把它与 %2 连接起来。</translation>
    </message>
    <message>
        <source>%1 was drawn beside its slit: it was given a neck, and cut flat at the ground.</source>
        <translation>%1 画在了插槽旁边：已加上连接颈，并在地面处切平。</translation>
    </message>
    <message>
        <source>%1 was drawn beside its slit and was given a neck that reaches into it.</source>
        <translation>%1 画在了插槽旁边，已加上伸进插槽的连接颈。</translation>
    </message>
    <message>
        <source>%1 is not symmetric: its halves differ.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 不对称：它的两半不同。</translation>
    </message>
    <message>
        <source>Drag an arrow to move %1, a ring to turn it, a box to scale it; or type numbers. &lt;kbd&gt;Esc&lt;/kbd&gt; hides the handles.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>拖动箭头移动 %1，圆环转动它，方块缩放它；也可输入数字。&lt;kbd&gt;Esc&lt;/kbd&gt; 隐藏手柄。</translation>
    </message>
    <message>
        <source>Drag to move; &lt;kbd&gt;Shift&lt;/kbd&gt; keeps to one direction.</source>
        <translation>拖动移动；&lt;kbd&gt;Shift&lt;/kbd&gt; 保持一个方向。</translation>
    </message>
    <message>
        <source>Drag to turn.</source>
        <translation>拖动转动。</translation>
    </message>
    <message>
        <source>Drag to scale.</source>
        <translation>拖动缩放。</translation>
    </message>
    <message>
        <source>Release to keep it like this. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>松开就保持这样。&lt;kbd&gt;Esc&lt;/kbd&gt; 取消。</translation>
    </message>
    <message>
        <source>%1 is locked.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>%1 已锁定。</translation>
    </message>
    <message>
        <source>%1 cannot be moved or scaled that far.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>%1 不能移动或缩放那么多。</translation>
    </message>
    <message>
        <source>Drag along something in %1 whose length you know; &lt;kbd&gt;Shift&lt;/kbd&gt; keeps to eight directions. &lt;kbd&gt;Esc&lt;/kbd&gt; ends.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>沿着 %1 中已知长度的地方拖动；&lt;kbd&gt;Shift&lt;/kbd&gt; 限定在八个方向。&lt;kbd&gt;Esc&lt;/kbd&gt; 结束。</translation>
    </message>
    <message>
        <source>Type how long that is; &lt;kbd&gt;Enter&lt;/kbd&gt; makes %1 that large. &lt;kbd&gt;Esc&lt;/kbd&gt; clears the line.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>输入它有多长；&lt;kbd&gt;Enter&lt;/kbd&gt; 让 %1 变成那么大。&lt;kbd&gt;Esc&lt;/kbd&gt; 清除这条线。</translation>
    </message>
    <message>
        <source>No flat piece of %1 is large enough for a section: make it larger first.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>%1 没有足够大的平块可做插片：请先把它放大。</translation>
    </message>
    <message>
        <source>It has more than %1 flat pieces: choose fewer faces.</source>
        <translation>它的平块超过 %1 个：请减少面数。</translation>
    </message>
    <message>
        <source>A sheet of %1 does not fold: choose a stock of %2 or less.</source>
        <extracomment>A sheet. %1 and %2 are lengths</extracomment>
        <translation>%1 的板材折不了：请选择 %2 或更薄的材料。</translation>
    </message>
    <message numerus="yes">
        <source>Fold along the scored lines, then join edges with the same number: %n seams.</source>
        <translation>
            <numerusform>沿刻线折叠，再把编号相同的边接起来：共 %n 条接缝。</numerusform>
        </translation>
    </message>
    <message>
        <source>Click the section to move or turn, or drag it. &lt;kbd&gt;Esc&lt;/kbd&gt; hides the handles.</source>
        <translation>点击要移动或转动的插片，或直接拖动它。&lt;kbd&gt;Esc&lt;/kbd&gt; 隐藏手柄。</translation>
    </message>
    <message>
        <source>Drag an arrow to move, a ring to turn, a box to scale; or type numbers. &lt;kbd&gt;Esc&lt;/kbd&gt; hides the handles.</source>
        <translation>拖动箭头移动，圆环转动，方块缩放；也可输入数字。&lt;kbd&gt;Esc&lt;/kbd&gt; 隐藏手柄。</translation>
    </message>
    <message>
        <source>Drag to move %1; click to select it.</source>
        <translation>拖动移动 %1；点击选中它。</translation>
    </message>
    <message>
        <source>Drag to move; &lt;kbd&gt;Ctrl&lt;/kbd&gt; leaves a copy, &lt;kbd&gt;Shift&lt;/kbd&gt; keeps to one direction.</source>
        <translation>拖动移动；&lt;kbd&gt;Ctrl&lt;/kbd&gt; 留下副本，&lt;kbd&gt;Shift&lt;/kbd&gt; 保持一个方向。</translation>
    </message>
    <message>
        <source>Drag to turn; &lt;kbd&gt;Ctrl&lt;/kbd&gt; leaves a copy.</source>
        <translation>拖动转动；&lt;kbd&gt;Ctrl&lt;/kbd&gt; 留下副本。</translation>
    </message>
    <message>
        <source>Drag to scale; &lt;kbd&gt;Ctrl&lt;/kbd&gt; leaves a copy.</source>
        <translation>拖动缩放；&lt;kbd&gt;Ctrl&lt;/kbd&gt; 留下副本。</translation>
    </message>
    <message>
        <source>Release to keep it like this. &lt;kbd&gt;Ctrl&lt;/kbd&gt; leaves a copy, &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>松开就保持这样。&lt;kbd&gt;Ctrl&lt;/kbd&gt; 留下副本，&lt;kbd&gt;Esc&lt;/kbd&gt; 取消。</translation>
    </message>
    <message>
        <source>Release to leave a copy here. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>松开在这里留下副本。&lt;kbd&gt;Esc&lt;/kbd&gt; 取消。</translation>
    </message>
    <message>
        <source>&lt;kbd&gt;Enter&lt;/kbd&gt; keeps it like this. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>&lt;kbd&gt;Enter&lt;/kbd&gt; 保持这样。&lt;kbd&gt;Esc&lt;/kbd&gt; 取消。</translation>
    </message>
    <message numerus="yes">
        <source>&lt;kbd&gt;Enter&lt;/kbd&gt; makes %n copies like this, each a step further. &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>
            <numerusform>&lt;kbd&gt;Enter&lt;/kbd&gt; 生成 %n 个这样的副本，每个再前进一步。&lt;kbd&gt;Esc&lt;/kbd&gt; 取消。</numerusform>
        </translation>
    </message>
    <message>
        <source>A preset needs a name, without “=” and blanks at its ends.</source>
        <translation>预设需要一个名称，不含“=”，两端没有空格。</translation>
    </message>
    <message>
        <source>Others can adjust no value yet, so there is nothing to keep.</source>
        <translation>还没有别人可以调整的参数，所以没有可保留的内容。</translation>
    </message>
    <message>
        <source>There is no preset named “%1”.</source>
        <extracomment>%1 is what somebody took for the name of a preset</extracomment>
        <translation>没有名为“%1”的预设。</translation>
    </message>
    <message>
        <source>This is what others see. Save the file and give it to them; it opens like this.</source>
        <translation>别人看到的就是这样。保存文件并交给他们；打开就是这个样子。</translation>
    </message>
    <message numerus="yes">
        <source>%n that were made of it are plain numbers now.</source>
        <extracomment>%n numbers were made of a value that is removed</extracomment>
        <translation>
            <numerusform>由它构成的 %n 个数字现在成了普通数字。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n presets that set nothing else are gone with it.</source>
        <extracomment>%n presets set nothing but a value that is removed</extracomment>
        <translation>
            <numerusform>%n 个没有设置其他内容的预设也随之消失了。</numerusform>
        </translation>
    </message>
    <message>
        <source>No narrower ranges were found in which the model holds.</source>
        <translation>没有找到能让模型撑住的更窄范围。</translation>
    </message>
    <message>
        <source>Move to turn the view, release to stop.</source>
        <translation>移动鼠标转动视图，松开停止。</translation>
    </message>
    <message>
        <source>Move to shift the view, release to stop.</source>
        <translation>移动鼠标平移视图，松开停止。</translation>
    </message>
    <message>
        <source>Move up to zoom in, down to zoom out; release to stop.</source>
        <translation>向上移动放大，向下移动缩小；松开停止。</translation>
    </message>
    <message>
        <source>Nothing changed: this cannot be done here.</source>
        <translation>没有改动：这里不能这样做。</translation>
    </message>
    <message>
        <source>%1 is locked. Unlock it in the Outline to change it.</source>
        <translation>%1 已锁定。要改动它，请在大纲中解锁。</translation>
    </message>
    <message>
        <source>%1 is made by %2: edit its source, or detach this one.</source>
        <translation>%1 由 %2 生成：请编辑它的来源，或分离这一个。</translation>
    </message>
    <message>
        <source>Nothing would be left of %1; it stays as it was.</source>
        <translation>%1 会什么都不剩；它保持原样。</translation>
    </message>
    <message>
        <source>%1 was cut flat at the ground.</source>
        <translation>%1 已在地面处切平。</translation>
    </message>
    <message>
        <source>%1 fell apart when it was cut flat at the ground; the largest piece was kept.</source>
        <translation>%1 在地面处切平后散开了；保留了最大的一块。</translation>
    </message>
    <message>
        <source>Nothing pasted: what was copied has neither sections nor a picture in it.</source>
        <translation>没有粘贴：复制的内容里既没有插片，也没有图片。</translation>
    </message>
    <message>
        <source>Nothing copied: the model is symmetric already.</source>
        <translation>没有复制：模型已经对称。</translation>
    </message>
    <message>
        <source>Nothing deleted: a joint is where two sections meet. Delete one of them, or choose the kind “None”.</source>
        <translation>没有删除：接头是两个插片相接的地方。请删除其中一个，或把类型选为“无”。</translation>
    </message>
    <message>
        <source>“%1” is what is set now, in place of what it was.</source>
        <extracomment>%1 is the name of a preset of values, such as A5</extracomment>
        <translation>“%1”现在是当前的设置，取代了原来的。</translation>
    </message>
    <message>
        <source>Draw a section first: there is nothing to mirror yet.</source>
        <translation>请先画一个插片：还没有可镜像的东西。</translation>
    </message>
    <message>
        <source>Draw a section first: there is nothing to repeat or divide yet.</source>
        <translation>请先画一个插片：还没有可重复或可分割的东西。</translation>
    </message>
    <message numerus="yes">
        <source>%n edges have no fingers: their sheets meet too flat or too sharply, or are too short there. Fewer faces help, or slices instead.</source>
        <translation>
            <numerusform>%n 条边没有指接：那里的板材相交得太平或太尖，或者太短。减少面数会有帮助，或改用切片。</numerusform>
        </translation>
    </message>
    <message>
        <source>Adds a mirror image of what is selected. &lt;kbd&gt;Enter&lt;/kbd&gt; mirrors; &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>添加所选内容的镜像。&lt;kbd&gt;Enter&lt;/kbd&gt; 镜像；&lt;kbd&gt;Esc&lt;/kbd&gt; 取消。</translation>
    </message>
    <message>
        <source>What you change on one side changes on the other. &lt;kbd&gt;Enter&lt;/kbd&gt; mirrors; &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>改动一侧时，另一侧也随之改变。&lt;kbd&gt;Enter&lt;/kbd&gt; 镜像；&lt;kbd&gt;Esc&lt;/kbd&gt; 取消。</translation>
    </message>
    <message>
        <source>Makes both sides the same once; then each is its own. &lt;kbd&gt;Enter&lt;/kbd&gt; mirrors; &lt;kbd&gt;Esc&lt;/kbd&gt; cancels.</source>
        <translation>使两侧相同一次，之后各自独立。&lt;kbd&gt;Enter&lt;/kbd&gt; 镜像；&lt;kbd&gt;Esc&lt;/kbd&gt; 取消。</translation>
    </message>
</context>
<context>
    <name>Listing</name>
    <message>
        <source>, </source>
        <extracomment>between the entries of a list in a sentence, with its blank</extracomment>
        <translation>、</translation>
    </message>
</context>
<context>
    <name>LoadPreset</name>
    <message>
        <source>Glass of water</source>
        <translation>一杯水</translation>
    </message>
    <message>
        <source>Fork</source>
        <translation>叉子</translation>
    </message>
    <message>
        <source>Knife</source>
        <translation>刀子</translation>
    </message>
    <message>
        <source>Spoon</source>
        <translation>勺子</translation>
    </message>
    <message>
        <source>Book</source>
        <translation>书</translation>
    </message>
    <message>
        <source>Plant pot</source>
        <translation>花盆</translation>
    </message>
</context>
<context>
    <name>Mesh</name>
    <message>
        <source>A face was left out: a corner of it is not there.</source>
        <translation>略去了一个面：它有一个角不存在。</translation>
    </message>
    <message numerus="yes">
        <source>%n faces were left out: a corner of theirs is not there.</source>
        <translation>
            <numerusform>略去了 %n 个面：它们有的角不存在。</numerusform>
        </translation>
    </message>
    <message>
        <source>A face was left out: the place of a corner is no number.</source>
        <translation>略去了一个面：有个角的位置不是数。</translation>
    </message>
    <message numerus="yes">
        <source>%n faces were left out: the place of a corner is no number.</source>
        <translation>
            <numerusform>略去了 %n 个面：有的角的位置不是数。</numerusform>
        </translation>
    </message>
    <message>
        <source>A face was left out: it has a corner twice.</source>
        <translation>略去了一个面：它有一个角重复。</translation>
    </message>
    <message numerus="yes">
        <source>%n faces were left out: they have a corner twice.</source>
        <translation>
            <numerusform>略去了 %n 个面：它们有的角重复。</numerusform>
        </translation>
    </message>
    <message>
        <source>A face was left out: it is there twice.</source>
        <translation>略去了一个面：它重复了。</translation>
    </message>
    <message numerus="yes">
        <source>%n faces were left out: they are there twice.</source>
        <translation>
            <numerusform>略去了 %n 个面：它们重复了。</numerusform>
        </translation>
    </message>
    <message>
        <source>A face looked the wrong way and was turned over.</source>
        <translation>一个面朝向不对，已翻过来。</translation>
    </message>
    <message numerus="yes">
        <source>%n faces looked the wrong way and were turned over.</source>
        <translation>
            <numerusform>%n 个面朝向不对，已翻过来。</numerusform>
        </translation>
    </message>
    <message>
        <source>The surface has a hole: an edge is open.</source>
        <translation>表面有洞：一条边是开口的。</translation>
    </message>
    <message numerus="yes">
        <source>The surface has holes: %n edges are open.</source>
        <translation>
            <numerusform>表面有洞：%n 条边是开口的。</numerusform>
        </translation>
    </message>
    <message>
        <source>More than two faces meet at an edge.</source>
        <translation>有一条边上相接的面超过两个。</translation>
    </message>
    <message numerus="yes">
        <source>More than two faces meet at %n edges.</source>
        <translation>
            <numerusform>有 %n 条边上相接的面超过两个。</numerusform>
        </translation>
    </message>
    <message>
        <source>At an edge faces meet that cannot look the same way.</source>
        <translation>有一条边上相接的面无法朝向一致。</translation>
    </message>
    <message numerus="yes">
        <source>At %n edges faces meet that cannot look the same way.</source>
        <translation>
            <numerusform>有 %n 条边上相接的面无法朝向一致。</numerusform>
        </translation>
    </message>
    <message>
        <source>It was inside out and was turned over.</source>
        <translation>它里外反了，已翻过来。</translation>
    </message>
    <message>
        <source>A gap in the cut was closed by a smooth curve.</source>
        <translation>截面上的一处缺口已用平滑曲线补上。</translation>
    </message>
    <message numerus="yes">
        <source>%n gaps in the cut were closed by smooth curves.</source>
        <translation>
            <numerusform>截面上的 %n 处缺口已用平滑曲线补上。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>MirrorBar</name>
    <message>
        <source>Plane</source>
        <extracomment>before the buttons X, Y, Z and Section, the plane that is mirrored across</extracomment>
        <translation>镜面</translation>
    </message>
    <message>
        <source>How</source>
        <extracomment>before the buttons Copy, Both sides and Once</extracomment>
        <translation>方式</translation>
    </message>
</context>
<context>
    <name>Offcut</name>
    <message>
        <source>%1 does not say how large it is in mm or inches; the offcut is taken as %2 × %3 mm.</source>
        <extracomment>%1 is a file&apos;s name, %2 x %3 the size of an offcut</extracomment>
        <translation>%1 没有以 mm 或英寸说明大小；余料按 %2 × %3 mm 处理。</translation>
    </message>
    <message>
        <source>%1: the outline crosses itself; the largest piece of it is taken, %2 × %3 mm.</source>
        <translation>%1：轮廓线与自身相交；取其中最大的一块，%2 × %3 mm。</translation>
    </message>
    <message>
        <source>%1: lines cut the offcut into pieces; the largest is taken, %2 × %3 mm.</source>
        <translation>%1：有线条把余料切成几块；取最大的一块，%2 × %3 mm。</translation>
    </message>
    <message>
        <source>%1: lines in the offcut are open; what they would enclose if they were closed is left free.</source>
        <extracomment>%1 is a file&apos;s name</extracomment>
        <translation>%1：余料中有未闭合的线；它们闭合后围出的部分留空。</translation>
    </message>
</context>
<context>
    <name>Operation</name>
    <message>
        <source>Count</source>
        <translation>数量</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>直线</translation>
    </message>
    <message>
        <source>Including the sections that are there already</source>
        <translation>包括已有的插片</translation>
    </message>
    <message>
        <source>Step X</source>
        <translation>步距 X</translation>
    </message>
    <message>
        <source>Step Y</source>
        <translation>步距 Y</translation>
    </message>
    <message>
        <source>Step Z</source>
        <translation>步距 Z</translation>
    </message>
    <message>
        <source>Array</source>
        <translation>阵列</translation>
    </message>
    <message>
        <source>Repeats sections along a line through space.</source>
        <translation>沿空间中的一条直线重复插片。</translation>
    </message>
    <message>
        <source>%1 array</source>
        <extracomment>%1 is the name of a section: &quot;Rib array&quot;</extracomment>
        <translation>%1 阵列</translation>
    </message>
    <message>
        <source>Sections</source>
        <translation>插片</translation>
    </message>
    <message>
        <source>Click the sections to repeat.</source>
        <translation>点击要重复的插片。</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>过渡</translation>
    </message>
    <message>
        <source>Interpolates between sections.</source>
        <translation>在插片之间插补出中间形状。</translation>
    </message>
    <message>
        <source>%1 blend</source>
        <extracomment>%1 is the name of a section: &quot;Rib blend&quot;</extracomment>
        <translation>%1 过渡</translation>
    </message>
    <message>
        <source>Click the sections to blend, in order.</source>
        <translation>按顺序点击要过渡的插片。</translation>
    </message>
    <message>
        <source>Along</source>
        <translation>沿着</translation>
    </message>
    <message>
        <source>Click the section it should run along.</source>
        <translation>点击它要沿着的插片。</translation>
    </message>
    <message>
        <source>Count per gap</source>
        <translation>每段数量</translation>
    </message>
    <message>
        <source>Placing</source>
        <translation>排布</translation>
    </message>
    <message>
        <source>Easing</source>
        <translation>节奏</translation>
    </message>
    <message>
        <source>Even</source>
        <translation>均匀</translation>
    </message>
    <message>
        <source>Slow ends</source>
        <translation>两端放慢</translation>
    </message>
    <message>
        <source>Match</source>
        <translation>对应方式</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>As drawn</source>
        <translation>按所画</translation>
    </message>
    <message>
        <source>Reverse</source>
        <translation>反向</translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation>迭代次数</translation>
    </message>
    <message>
        <source>Growth</source>
        <translation>生长</translation>
    </message>
    <message>
        <source>Size of a copy</source>
        <translation>副本大小</translation>
    </message>
    <message>
        <source>Vary size ±</source>
        <translation>大小变化 ±</translation>
    </message>
    <message>
        <source>Vary angle ±</source>
        <translation>角度变化 ±</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>随机种子</translation>
    </message>
    <message>
        <source>Smallest</source>
        <translation>最小</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>限制</translation>
    </message>
    <message>
        <source>At most</source>
        <translation>最多</translation>
    </message>
    <message>
        <source>Branch</source>
        <translation>分枝</translation>
    </message>
    <message>
        <source>Grows copies of a section and all that is on it in place of its children, again and again.</source>
        <translation>让插片及其上的一切长出副本，取代它的子插片，如此反复。</translation>
    </message>
    <message>
        <source>%1 branch</source>
        <extracomment>%1 is the name of a section: &quot;Rib branch&quot;</extracomment>
        <translation>%1 分枝</translation>
    </message>
    <message>
        <source>Root</source>
        <translation>根</translation>
    </message>
    <message>
        <source>Click the section that branches.</source>
        <translation>点击要分枝的插片。</translation>
    </message>
    <message>
        <source>Held by</source>
        <translation>固定于</translation>
    </message>
    <message>
        <source>Click the section that holds it: copies are held the same way.</source>
        <translation>点击固定它的插片：副本也用同样方式固定。</translation>
    </message>
    <message>
        <source>Children</source>
        <translation>子插片</translation>
    </message>
    <message>
        <source>Click the attached sections that copies should replace.</source>
        <translation>点击要由副本取代的依附插片。</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>分格</translation>
    </message>
    <message>
        <source>Divides a section that is too large into cells that hold together.</source>
        <translation>把太大的插片分成能固定在一起的格子。</translation>
    </message>
    <message>
        <source>%1 grid</source>
        <extracomment>%1 is the name of a section: &quot;Rib grid&quot;</extracomment>
        <translation>%1 分格</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>插片</translation>
    </message>
    <message>
        <source>Click the section to divide.</source>
        <translation>点击要分开的插片。</translation>
    </message>
    <message>
        <source>Fit my sheet</source>
        <translation>适合我的板材</translation>
    </message>
    <message>
        <source>Cells</source>
        <translation>格子</translation>
    </message>
    <message>
        <source>Cell width</source>
        <translation>格宽</translation>
    </message>
    <message>
        <source>Cell height</source>
        <translation>格高</translation>
    </message>
    <message>
        <source>Edge</source>
        <translation>分界</translation>
    </message>
    <message>
        <source>Straight with connectors</source>
        <translation>直边加连接件</translation>
    </message>
    <message>
        <source>Jigsaw</source>
        <translation>拼图形</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>分界</translation>
    </message>
    <message>
        <source>Connectors per edge</source>
        <translation>每条边的连接件</translation>
    </message>
    <message>
        <source>Connector size</source>
        <translation>连接件大小</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>间隙</translation>
    </message>
    <message>
        <source>Merge slivers below</source>
        <translation>合并碎片，小于</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>朝向</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>向前</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>向后</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>两侧</translation>
    </message>
    <message>
        <source>Equal depth inside</source>
        <translation>里面深度相同</translation>
    </message>
    <message>
        <source>The same length of each copy lies inside the other section</source>
        <translation>每个副本在另一个插片里的长度都相同</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>成排</translation>
    </message>
    <message>
        <source>Repeats a section in a row along another one.</source>
        <translation>沿另一个插片把一个插片重复排成一排。</translation>
    </message>
    <message>
        <source>%1 row</source>
        <extracomment>%1 is the name of a section: &quot;Rib row&quot;</extracomment>
        <translation>%1 成排</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>圆</translation>
    </message>
    <message>
        <source>Star</source>
        <translation>星形</translation>
    </message>
    <message>
        <source>Gear</source>
        <translation>齿轮</translation>
    </message>
    <message>
        <source>Holes</source>
        <translation>孔</translation>
    </message>
    <message>
        <source>Drawn sector</source>
        <translation>手画扇区</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>形状</translation>
    </message>
    <message>
        <source>Sectors</source>
        <translation>扇区数</translation>
    </message>
    <message>
        <source>Outer radius</source>
        <translation>外半径</translation>
    </message>
    <message>
        <source>Inner radius</source>
        <translation>内半径</translation>
    </message>
    <message>
        <source>Tooth</source>
        <translation>齿形</translation>
    </message>
    <message>
        <source>Round</source>
        <translation>圆形</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>方形</translation>
    </message>
    <message>
        <source>Trapezium</source>
        <translation>梯形</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>起始角</translation>
    </message>
    <message>
        <source>Apply to</source>
        <translation>应用到</translation>
    </message>
    <message>
        <source>Contour</source>
        <translation>轮廓</translation>
    </message>
    <message>
        <source>%1 circle</source>
        <translation>%1 圆</translation>
    </message>
    <message>
        <source>%1 star</source>
        <translation>%1 星形</translation>
    </message>
    <message>
        <source>%1 holes</source>
        <translation>%1 孔</translation>
    </message>
    <message>
        <source>%1 rosette</source>
        <translation>%1 花形</translation>
    </message>
    <message>
        <source>%1 gear</source>
        <translation>%1 齿轮</translation>
    </message>
    <message>
        <source>Radial</source>
        <translation>径向</translation>
    </message>
    <message>
        <source>Turns a section into a circle, a star or a gear, or cuts such holes into it.</source>
        <translation>把插片变成圆、星形或齿轮，或开出这样的孔。</translation>
    </message>
    <message>
        <source>Click the section to shape.</source>
        <translation>点击要改变形状的插片。</translation>
    </message>
    <message>
        <source>Click the section to repeat.</source>
        <translation>点击要重复的插片。</translation>
    </message>
    <message>
        <source>Whole branch</source>
        <translation>整枝</translation>
    </message>
    <message>
        <source>With everything that is attached to it</source>
        <translation>连同依附在它上面的一切</translation>
    </message>
    <message>
        <source>Repeat by</source>
        <translation>重复方式</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>间距</translation>
    </message>
    <message>
        <source>From</source>
        <translation>起点</translation>
    </message>
    <message>
        <source>To</source>
        <translation>终点</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>缩放</translation>
    </message>
    <message>
        <source>No</source>
        <translation>不缩放</translation>
    </message>
    <message>
        <source>By local thickness</source>
        <translation>按所在处粗细</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大小</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>Whole section</source>
        <translation>整个插片</translation>
    </message>
    <message>
        <source>Along the slit</source>
        <translation>沿插槽</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>力度</translation>
    </message>
    <message>
        <source>Not below</source>
        <translation>不小于</translation>
    </message>
    <message>
        <source>Outside</source>
        <translation>外侧</translation>
    </message>
    <message>
        <source>Inside</source>
        <translation>内侧</translation>
    </message>
    <message>
        <source>Angle to edge</source>
        <translation>与边缘的角度</translation>
    </message>
    <message>
        <source>All the way round</source>
        <translation>绕一整圈</translation>
    </message>
    <message>
        <source>Revolve</source>
        <translation>环绕</translation>
    </message>
    <message>
        <source>Repeats a section round the contour of another one.</source>
        <translation>绕着另一个插片的轮廓重复一个插片。</translation>
    </message>
    <message>
        <source>%1 fan</source>
        <extracomment>%1 is the name of a section: &quot;Rib fan&quot;</extracomment>
        <translation>%1 环绕</translation>
    </message>
    <message>
        <source>Planes</source>
        <translation>平面</translation>
    </message>
    <message>
        <source>across X</source>
        <translation>垂直于 X</translation>
    </message>
    <message>
        <source>across Y</source>
        <translation>垂直于 Y</translation>
    </message>
    <message>
        <source>across Z</source>
        <translation>垂直于 Z</translation>
    </message>
    <message>
        <source>across X and Y</source>
        <translation>垂直于 X 和 Y</translation>
    </message>
    <message>
        <source>across X and Z</source>
        <translation>垂直于 X 和 Z</translation>
    </message>
    <message>
        <source>across Y and Z</source>
        <translation>垂直于 Y 和 Z</translation>
    </message>
    <message>
        <source>along a curve</source>
        <translation>沿曲线</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>切片</translation>
    </message>
    <message>
        <source>By</source>
        <translation>方式</translation>
    </message>
    <message>
        <source>In each direction</source>
        <translation>每个方向</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>偏移</translation>
    </message>
    <message>
        <source>Of all planes, as a part of their spacing</source>
        <translation>所有平面的偏移，占间距的比例</translation>
    </message>
    <message>
        <source>Smallest piece</source>
        <translation>最小块</translation>
    </message>
    <message>
        <source>In mm²; smaller ones are left out, and those that are thin all over</source>
        <translation>单位 mm²；更小的和处处都薄的会略去</translation>
    </message>
    <message>
        <source>Hollow</source>
        <translation>空心</translation>
    </message>
    <message>
        <source>Only a wall along the contour is left</source>
        <translation>只留下沿轮廓的一圈壁</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>壁厚</translation>
    </message>
    <message>
        <source>Cuts a mesh into sections that follow its form.</source>
        <translation>把网格切成贴合其形状的插片。</translation>
    </message>
    <message>
        <source>Click the section whose contour it should run along.</source>
        <translation>点击要沿着其轮廓走的插片。</translation>
    </message>
    <message>
        <source>Click the sections that it applies to.</source>
        <translation>点击它要作用的插片。</translation>
    </message>
    <message>
        <source>Applies to</source>
        <translation>作用于</translation>
    </message>
    <message>
        <source>Whole model</source>
        <translation>整个模型</translation>
    </message>
    <message>
        <source>Selection</source>
        <translation>所选内容</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>镜像</translation>
    </message>
    <message>
        <source>Repeats everything drawn on one side on the other.</source>
        <translation>画在一侧的所有内容，在另一侧重复。</translation>
    </message>
    <message>
        <source>Click the section to mirror across.</source>
        <translation>点击作为镜面的插片。</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>平面</translation>
    </message>
    <message>
        <source>A section&apos;s plane</source>
        <translation>插片的平面</translation>
    </message>
    <message>
        <source>Symmetry</source>
        <translation>对称</translation>
    </message>
    <message>
        <source>Join at the plane</source>
        <translation>在平面处相连</translation>
    </message>
    <message>
        <source>Rotational</source>
        <translation>旋转对称</translation>
    </message>
    <message>
        <source>Repeats everything drawn once all round an axis.</source>
        <translation>把画过一次的所有内容绕轴重复一圈。</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>轴</translation>
    </message>
    <message>
        <source>Click the two sections whose slit is the axis.</source>
        <translation>点击两个插片，它们的插槽就是轴。</translation>
    </message>
    <message>
        <source>Vertical</source>
        <translation>竖直</translation>
    </message>
    <message>
        <source>Slit</source>
        <translation>插槽</translation>
    </message>
    <message>
        <source>like a section</source>
        <translation>与插片平行</translation>
    </message>
    <message>
        <source>around Y</source>
        <translation>绕 Y</translation>
    </message>
    <message>
        <source>around X</source>
        <translation>绕 X</translation>
    </message>
    <message>
        <source>around Z</source>
        <translation>绕 Z</translation>
    </message>
    <message>
        <source>Like</source>
        <translation>参照</translation>
    </message>
    <message>
        <source>Click the section that they should be parallel to.</source>
        <translation>点击它们应与之平行的插片。</translation>
    </message>
</context>
<context>
    <name>OperationNotice</name>
    <message>
        <source>automatic</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>on</source>
        <translation>开</translation>
    </message>
    <message>
        <source>off</source>
        <translation>关</translation>
    </message>
    <message>
        <source>%1&#x202f;mm</source>
        <translation>%1&#x202f;mm</translation>
    </message>
    <message>
        <source>%1&#x202f;%</source>
        <translation>%1&#x202f;%</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>%1 makes nothing yet: choose its “%2”.</source>
        <extracomment>%1 is the name of an operation, %2 what it asks for: &quot;Along&quot;</extracomment>
        <translation>%1 还没有生成内容：请选择它的“%2”。</translation>
    </message>
    <message>
        <source>%1 has lost its section “%2”, which was deleted. It makes nothing until another one is chosen.</source>
        <extracomment>%1 is the name of an operation, %2 that of a section</extracomment>
        <translation>%1 的插片“%2”已被删除。另选一个之前，它不生成内容。</translation>
    </message>
    <message>
        <source>%1 makes nothing: its sections do not cross each other.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 没有生成内容：它的插片没有相交。</translation>
    </message>
    <message>
        <source>%1 makes nothing: there is no room within its range.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 没有生成内容：范围内没有空间。</translation>
    </message>
    <message>
        <source>%1 has nothing to divide: the section fits into a single cell.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 没有可分的：插片放得进一个格子。</translation>
    </message>
    <message>
        <source>%1 could not be worked out: its sections are missing.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>无法算出 %1：缺少它的插片。</translation>
    </message>
    <message>
        <source>%1 stopped at 1 section.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 到 1 个插片就停了。</translation>
    </message>
    <message numerus="yes">
        <source>%1 stopped at %n sections.</source>
        <translation>
            <numerusform>%1 到 %n 个插片就停了。</numerusform>
        </translation>
    </message>
    <message>
        <source>1 section of %1 was left out, as there is nothing to hold it.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 有 1 个插片已略去，因为没有东西固定它。</translation>
    </message>
    <message numerus="yes">
        <source>%n sections of %1 were left out, as there is nothing to hold them.</source>
        <translation>
            <numerusform>%1 有 %n 个插片已略去，因为没有东西固定它们。</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 makes nothing: its template is gone or its file is missing.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 没有生成内容：它的参考物不在了，或缺少文件。</translation>
    </message>
    <message>
        <source>1 small piece of %1 was left out.</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>%1 有 1 个小块已略去。</translation>
    </message>
    <message numerus="yes">
        <source>%n small pieces of %1 were left out.</source>
        <translation>
            <numerusform>%1 有 %n 个小块已略去。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Pdf</name>
    <message>
        <source>%1 mm: print at 100 %</source>
        <translation>%1 mm：按 100 % 打印</translation>
    </message>
    <message>
        <source>Sheet %1, page %2</source>
        <translation>板材 %1，第 %2 页</translation>
    </message>
</context>
<context>
    <name>QDockWidget</name>
    <message>
        <source>Float</source>
        <translation>浮动</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
</context>
<context>
    <name>QProgressDialog</name>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
</context>
<context>
    <name>QShortcut</name>
    <message>
        <source>Ctrl</source>
        <extracomment>keys, as they are labelled on a keyboard of the country, in menus: &quot;Ctrl+Shift+S&quot;</extracomment>
        <translation>Ctrl</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Shift</translation>
    </message>
    <message>
        <source>Alt</source>
        <translation>Alt</translation>
    </message>
    <message>
        <source>Meta</source>
        <translation>Meta</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Home</translation>
    </message>
    <message>
        <source>End</source>
        <translation>End</translation>
    </message>
    <message>
        <source>Del</source>
        <translation>Del</translation>
    </message>
    <message>
        <source>Ins</source>
        <translation>Ins</translation>
    </message>
    <message>
        <source>PgUp</source>
        <translation>Page Up</translation>
    </message>
    <message>
        <source>PgDown</source>
        <translation>Page Down</translation>
    </message>
    <message>
        <source>Tab</source>
        <translation>Tab</translation>
    </message>
    <message>
        <source>Backspace</source>
        <translation>Backspace</translation>
    </message>
    <message>
        <source>Return</source>
        <translation>回车</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>回车</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>空格</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>左</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>右</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>上</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>下</translation>
    </message>
</context>
<context>
    <name>Stage</name>
    <message>
        <source>Stopped: %1. It is worked out again when the model changes.</source>
        <extracomment>%1 is what would have been found out: &quot;the order of assembly&quot;</extracomment>
        <translation>已停止：%1。模型改动后会重新计算。</translation>
    </message>
    <message>
        <source>Could not be worked out: %1. Reason: %2.</source>
        <extracomment>%1 is what would have been found out: &quot;the order of assembly&quot;, %2 a sentence</extracomment>
        <translation>无法算出：%1。原因：%2。</translation>
    </message>
    <message>
        <source>what can be done about problems</source>
        <translation>问题的解决办法</translation>
    </message>
    <message>
        <source>Working out %1…</source>
        <extracomment>%1 is what is found out: &quot;the order of assembly&quot;</extracomment>
        <translation>正在计算%1…</translation>
    </message>
    <message>
        <source>Working out %1… %2&#x202f;%</source>
        <extracomment>%1 is what is found out: &quot;the order of assembly&quot;, %2 a number</extracomment>
        <translation>正在计算%1… %2&#x202f;%</translation>
    </message>
    <message>
        <source>the joints and slits</source>
        <translation>接头和插槽</translation>
    </message>
    <message>
        <source>the checks</source>
        <translation>各项检查</translation>
    </message>
    <message>
        <source>the order of assembly</source>
        <translation>拼装顺序</translation>
    </message>
    <message>
        <source>whether it holds</source>
        <translation>是否撑得住</translation>
    </message>
    <message>
        <source>how much it holds when sections bend</source>
        <translation>插片弯曲时能承受多少</translation>
    </message>
    <message>
        <source>how much each place of a section holds</source>
        <translation>插片各处能承受多少</translation>
    </message>
    <message>
        <source>the skin</source>
        <translation>蒙皮</translation>
    </message>
    <message>
        <source>how parts lie on the sheets</source>
        <translation>零件在板材上的排版</translation>
    </message>
    <message>
        <source>what magnets make of templates</source>
        <translation>参考物的磁吸变形</translation>
    </message>
    <message>
        <source>what frees parts that block each other</source>
        <translation>怎样放开互相卡住的零件</translation>
    </message>
</context>
<context>
    <name>Step</name>
    <message>
        <source>Set up cutting</source>
        <translation>设置切割</translation>
    </message>
    <message>
        <source>Edit %1</source>
        <extracomment>%1 is the name of a stock</extracomment>
        <translation>编辑 %1</translation>
    </message>
    <message>
        <source>Change stock of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>更换 %1 的材料</translation>
    </message>
    <message numerus="yes">
        <source>Change stock of %n sections</source>
        <translation>
            <numerusform>更换 %n 个插片的材料</numerusform>
        </translation>
    </message>
    <message>
        <source>Insert %1</source>
        <extracomment>%1 is the name of a file</extracomment>
        <translation>插入 %1</translation>
    </message>
    <message>
        <source>Drop to the ground</source>
        <translation>落到地面</translation>
    </message>
    <message>
        <source>Widen the base of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>加宽 %1 的底部</translation>
    </message>
    <message>
        <source>Add a foot to %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>给 %1 加支脚</translation>
    </message>
    <message>
        <source>Join %1 and %2</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>连接 %1 和 %2</translation>
    </message>
    <message>
        <source>Move %1 to %2</source>
        <extracomment>%1 is the name of a section, %2 of the one that it comes to</extracomment>
        <translation>把 %1 移到 %2</translation>
    </message>
    <message numerus="yes">
        <source>Move %n sections to %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>
            <numerusform>把 %n 个插片移到 %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Flip slits of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>翻转 %1 的插槽</translation>
    </message>
    <message>
        <source>Move %1 by %2</source>
        <extracomment>%1 is the name of a section, %2 a length</extracomment>
        <translation>把 %1 移动 %2</translation>
    </message>
    <message>
        <source>Make assemblable</source>
        <translation>改成可拼装</translation>
    </message>
    <message>
        <source>Support %1 with a foot</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>用支脚撑住 %1</translation>
    </message>
    <message>
        <source>Stretch %1 to the ground</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>把 %1 延长到地面</translation>
    </message>
    <message numerus="yes">
        <source>Stretch %n sections to the ground</source>
        <translation>
            <numerusform>把 %n 个插片延长到地面</numerusform>
        </translation>
    </message>
    <message>
        <source>Make %1 %2 thick</source>
        <extracomment>%1 is the name of a stock, %2 a length</extracomment>
        <translation>把 %1 改为 %2 厚</translation>
    </message>
    <message>
        <source>Turn %1 to 90°</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>把 %1 转到 90°</translation>
    </message>
    <message>
        <source>Make %1 wider where it is weak</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>把 %1 的薄弱处加宽</translation>
    </message>
    <message>
        <source>%1 · %2: flip the slits</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 · %2：翻转插槽</translation>
    </message>
    <message>
        <source>%1 · %2: meeting point → %3&#x202f;%</source>
        <extracomment>%1 and %2 are the names of two sections, %3 a number</extracomment>
        <translation>%1 · %2：相接点 → %3&#x202f;%</translation>
    </message>
    <message>
        <source>%1 · %2: restore automatic settings</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 · %2：恢复自动设置</translation>
    </message>
    <message>
        <source>%1 · %2: kind → cross lap</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 · %2：类型 → 十字搭接</translation>
    </message>
    <message>
        <source>%1 · %2: kind → extended cross lap</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 · %2：类型 → 加长十字搭接</translation>
    </message>
    <message>
        <source>%1 · %2: kind → mortise</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 · %2：类型 → 榫眼</translation>
    </message>
    <message>
        <source>%1 · %2: kind → tabs</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 · %2：类型 → 榫头</translation>
    </message>
    <message>
        <source>%1 · %2: kind → none</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>%1 · %2：类型 → 无</translation>
    </message>
    <message>
        <source>Trim %1 to %2</source>
        <extracomment>%1 and %2 are the names of two sections</extracomment>
        <translation>把 %1 修剪到 %2</translation>
    </message>
    <message>
        <source>Redraw %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>重画 %1</translation>
    </message>
    <message>
        <source>Draw a hole in %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>在 %1 上画孔</translation>
    </message>
    <message>
        <source>Draw %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>画 %1</translation>
    </message>
    <message>
        <source>Import %1</source>
        <extracomment>%1 is the name of a file</extracomment>
        <translation>导入 %1</translation>
    </message>
    <message>
        <source>Trace %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>描摹 %1</translation>
    </message>
    <message>
        <source>Change shape of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>更改 %1 的形状</translation>
    </message>
    <message>
        <source>Put %1 on %2</source>
        <extracomment>%1 is a mass, %2 the name of a section</extracomment>
        <translation>把 %1 放到 %2 上</translation>
    </message>
    <message>
        <source>Move the weight on %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>移动 %1 上的重物</translation>
    </message>
    <message>
        <source>Set weight to %1</source>
        <extracomment>%1 is a mass</extracomment>
        <translation>把重物设为 %1</translation>
    </message>
    <message>
        <source>Rename weight to %1</source>
        <extracomment>%1 is a name</extracomment>
        <translation>把重物重命名为 %1</translation>
    </message>
    <message>
        <source>Remove weight</source>
        <translation>移除重物</translation>
    </message>
    <message>
        <source>Push %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>推 %1</translation>
    </message>
    <message>
        <source>Move the push on %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>移动 %1 上的推力</translation>
    </message>
    <message>
        <source>Turn the push on %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>转动 %1 上的推力</translation>
    </message>
    <message>
        <source>Set push to %1</source>
        <extracomment>%1 is a force</extracomment>
        <translation>把推力设为 %1</translation>
    </message>
    <message>
        <source>Rename push to %1</source>
        <extracomment>%1 is a name</extracomment>
        <translation>把推力重命名为 %1</translation>
    </message>
    <message>
        <source>Remove push</source>
        <translation>移除推力</translation>
    </message>
    <message>
        <source>Spread the load on %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>分散 %1 上的载荷</translation>
    </message>
    <message>
        <source>Load the copies of %1 too</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>让 %1 的副本也承载</translation>
    </message>
    <message>
        <source>Keep the load off the copies of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>让 %1 的副本不承载</translation>
    </message>
    <message>
        <source>Pull templates to %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>把参考物磁吸到 %1</translation>
    </message>
    <message numerus="yes">
        <source>Pull templates to %n sections</source>
        <translation>
            <numerusform>把参考物磁吸到 %n 个插片</numerusform>
        </translation>
    </message>
    <message>
        <source>Release templates from %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>让 %1 放开参考物</translation>
    </message>
    <message numerus="yes">
        <source>Release templates from %n sections</source>
        <translation>
            <numerusform>让 %n 个插片放开参考物</numerusform>
        </translation>
    </message>
    <message>
        <source>Mark %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>标记 %1</translation>
    </message>
    <message>
        <source>Change mark of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>更改 %1 的标记</translation>
    </message>
    <message>
        <source>Delete mark of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>删除 %1 的标记</translation>
    </message>
    <message>
        <source>Scale the model to %1 %</source>
        <extracomment>%1 is a number of percent</extracomment>
        <translation>把模型缩放到 %1 %</translation>
    </message>
    <message>
        <source>Make %1 a circle</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>把 %1 变成圆</translation>
    </message>
    <message>
        <source>Make %1 an ellipse</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>把 %1 变成椭圆</translation>
    </message>
    <message>
        <source>Make the hole in %1 a circle</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>把 %1 上的孔变成圆</translation>
    </message>
    <message>
        <source>Make the hole in %1 an ellipse</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>把 %1 上的孔变成椭圆</translation>
    </message>
    <message>
        <source>Straighten lines of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>把 %1 的线变直</translation>
    </message>
    <message>
        <source>Make corners of %1 right angles</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>把 %1 的角变成直角</translation>
    </message>
    <message>
        <source>Move %1 in from the edge</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>把 %1 从边缘往里移</translation>
    </message>
    <message>
        <source>Add point to %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>给 %1 添加点</translation>
    </message>
    <message>
        <source>Delete point of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>删除 %1 的点</translation>
    </message>
    <message numerus="yes">
        <source>Delete %n points of %1</source>
        <translation>
            <numerusform>删除 %1 的 %n 个点</numerusform>
        </translation>
    </message>
    <message>
        <source>Move handle of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>移动 %1 的手柄</translation>
    </message>
    <message>
        <source>Bend contour of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>弯曲 %1 的轮廓</translation>
    </message>
    <message>
        <source>Move point of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>移动 %1 的点</translation>
    </message>
    <message numerus="yes">
        <source>Move %n points of %1</source>
        <translation>
            <numerusform>移动 %1 的 %n 个点</numerusform>
        </translation>
    </message>
    <message>
        <source>Change point of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>更改 %1 的点</translation>
    </message>
    <message numerus="yes">
        <source>Change %n points of %1</source>
        <translation>
            <numerusform>更改 %1 的 %n 个点</numerusform>
        </translation>
    </message>
    <message>
        <source>Move %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>移动 %1</translation>
    </message>
    <message numerus="yes">
        <source>Move %n sections</source>
        <translation>
            <numerusform>移动 %n 个插片</numerusform>
        </translation>
    </message>
    <message>
        <source>Turn %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>转动 %1</translation>
    </message>
    <message numerus="yes">
        <source>Turn %n sections</source>
        <translation>
            <numerusform>转动 %n 个插片</numerusform>
        </translation>
    </message>
    <message>
        <source>Scale %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>缩放 %1</translation>
    </message>
    <message numerus="yes">
        <source>Scale %n sections</source>
        <translation>
            <numerusform>缩放 %n 个插片</numerusform>
        </translation>
    </message>
    <message>
        <source>Copy %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>复制 %1</translation>
    </message>
    <message numerus="yes">
        <source>Copy %n sections</source>
        <translation>
            <numerusform>复制 %n 个插片</numerusform>
        </translation>
    </message>
    <message>
        <source>Mirror a copy of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>镜像 %1 的副本</translation>
    </message>
    <message numerus="yes">
        <source>Mirror copies of %n sections</source>
        <translation>
            <numerusform>镜像 %n 个插片的副本</numerusform>
        </translation>
    </message>
    <message>
        <source>Make %1 orthogonal</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>把 %1 转到垂直</translation>
    </message>
    <message numerus="yes">
        <source>Make %n sections orthogonal</source>
        <translation>
            <numerusform>把 %n 个插片转到垂直</numerusform>
        </translation>
    </message>
    <message>
        <source>Align %1 to an axis</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>把 %1 对齐到轴</translation>
    </message>
    <message numerus="yes">
        <source>Align %n sections to an axis</source>
        <translation>
            <numerusform>把 %n 个插片对齐到轴</numerusform>
        </translation>
    </message>
    <message>
        <source>Put %1 on another section</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>把 %1 放到另一个插片上</translation>
    </message>
    <message>
        <source>Free %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>让 %1 脱离</translation>
    </message>
    <message numerus="yes">
        <source>Free %n sections</source>
        <translation>
            <numerusform>让 %n 个插片脱离</numerusform>
        </translation>
    </message>
    <message>
        <source>Attach %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>让 %1 依附</translation>
    </message>
    <message numerus="yes">
        <source>Attach %n sections</source>
        <translation>
            <numerusform>让 %n 个插片依附</numerusform>
        </translation>
    </message>
    <message>
        <source>Change how %1 follows</source>
        <extracomment>%1 is the name of a section: how its place follows when the one that it is on is stretched</extracomment>
        <translation>更改 %1 的跟随方式</translation>
    </message>
    <message numerus="yes">
        <source>Change how %n sections follow</source>
        <translation>
            <numerusform>更改 %n 个插片的跟随方式</numerusform>
        </translation>
    </message>
    <message>
        <source>Lock %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>锁定 %1</translation>
    </message>
    <message numerus="yes">
        <source>Lock %n sections</source>
        <translation>
            <numerusform>锁定 %n 个插片</numerusform>
        </translation>
    </message>
    <message>
        <source>Unlock %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>解锁 %1</translation>
    </message>
    <message numerus="yes">
        <source>Unlock %n sections</source>
        <translation>
            <numerusform>解锁 %n 个插片</numerusform>
        </translation>
    </message>
    <message>
        <source>Place %1 on its sheet</source>
        <extracomment>%1 is the name of a section: its part lies elsewhere on the sheet</extracomment>
        <translation>移动板材上的 %1</translation>
    </message>
    <message>
        <source>Pin %1</source>
        <extracomment>%1 is the name of a section: its part stays where it lies on the sheet</extracomment>
        <translation>固定 %1</translation>
    </message>
    <message numerus="yes">
        <source>Pin %n parts</source>
        <translation>
            <numerusform>固定 %n 个零件</numerusform>
        </translation>
    </message>
    <message>
        <source>Unpin %1</source>
        <translation>取消固定 %1</translation>
    </message>
    <message numerus="yes">
        <source>Unpin %n sections</source>
        <translation>
            <numerusform>取消固定 %n 个插片</numerusform>
        </translation>
    </message>
    <message>
        <source>Unpin all parts</source>
        <translation>取消固定所有零件</translation>
    </message>
    <message>
        <source>Change rotation of %1</source>
        <extracomment>how parts may be turned on their sheet; %1 is the name of a section</extracomment>
        <translation>更改 %1 的旋转方式</translation>
    </message>
    <message numerus="yes">
        <source>Change rotation of %n sections</source>
        <translation>
            <numerusform>更改 %n 个插片的旋转方式</numerusform>
        </translation>
    </message>
    <message>
        <source>Keep %1 symmetric</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>保持 %1 对称</translation>
    </message>
    <message numerus="yes">
        <source>Keep %n sections symmetric</source>
        <translation>
            <numerusform>保持 %n 个插片对称</numerusform>
        </translation>
    </message>
    <message>
        <source>Let the halves of %1 differ</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>让 %1 的两半不同</translation>
    </message>
    <message numerus="yes">
        <source>Let the halves of %n sections differ</source>
        <translation>
            <numerusform>让 %n 个插片的两半不同</numerusform>
        </translation>
    </message>
    <message>
        <source>Add template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>添加参考物 %1</translation>
    </message>
    <message>
        <source>Remove template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>移除参考物 %1</translation>
    </message>
    <message>
        <source>Change template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>更改参考物 %1</translation>
    </message>
    <message>
        <source>Move template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>移动参考物 %1</translation>
    </message>
    <message>
        <source>Turn template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>转动参考物 %1</translation>
    </message>
    <message>
        <source>Scale template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>缩放参考物 %1</translation>
    </message>
    <message>
        <source>Align %1 and %2</source>
        <extracomment>%1 and %2 are the names of templates</extracomment>
        <translation>对齐 %1 和 %2</translation>
    </message>
    <message>
        <source>Hide template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>隐藏参考物 %1</translation>
    </message>
    <message>
        <source>Show template %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>显示参考物 %1</translation>
    </message>
    <message numerus="yes">
        <source>Suggest %n sections for %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>
            <numerusform>为 %1 建议 %n 个插片</numerusform>
        </translation>
    </message>
    <message>
        <source>Make facets of %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>用 %1 生成面片</translation>
    </message>
    <message>
        <source>Unfold %1</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>展开 %1</translation>
    </message>
    <message>
        <source>Add %1</source>
        <extracomment>%1 is the name of a value
----------
%1 is the name of an operation</extracomment>
        <translation>添加 %1</translation>
    </message>
    <message>
        <source>Set %1</source>
        <extracomment>%1 is the name of a value
----------
%1 is the name of a number</extracomment>
        <translation>设置 %1</translation>
    </message>
    <message>
        <source>Rename %1 to %2</source>
        <extracomment>%1 is the name a value had, %2 the one that it has now</extracomment>
        <translation>把 %1 重命名为 %2</translation>
    </message>
    <message>
        <source>Delete %1</source>
        <extracomment>%1 is the name of a value
----------
%1 is the name of a section
----------
%1 is the name of a number
----------
%1 is the name of an operation</extracomment>
        <translation>删除 %1</translation>
    </message>
    <message>
        <source>Keep the preset %1</source>
        <extracomment>%1 is the name of a preset of values, such as A5</extracomment>
        <translation>保留预设 %1</translation>
    </message>
    <message>
        <source>Set to %1</source>
        <extracomment>%1 is the name of a preset of values, such as A5</extracomment>
        <translation>设为 %1</translation>
    </message>
    <message>
        <source>Delete the preset %1</source>
        <extracomment>%1 is the name of a preset of values, such as A5</extracomment>
        <translation>删除预设 %1</translation>
    </message>
    <message>
        <source>Share for adjusting</source>
        <translation>交给别人调整</translation>
    </message>
    <message>
        <source>Edit the design</source>
        <translation>编辑设计</translation>
    </message>
    <message>
        <source>Set the values</source>
        <translation>设置参数</translation>
    </message>
    <message>
        <source>Narrow the ranges</source>
        <translation>收窄范围</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <extracomment>%1 is the name of a section or an operation</extracomment>
        <translation>重命名 %1</translation>
    </message>
    <message numerus="yes">
        <source>Delete %n sections</source>
        <translation>
            <numerusform>删除 %n 个插片</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2 → %3</source>
        <extracomment>%1 is the name of an operation, %2 of what it works on (&quot;Along&quot;), %3 of a section</extracomment>
        <translation>%1：%2 → %3</translation>
    </message>
    <message>
        <source>%1: %2 %3 → %4</source>
        <extracomment>%1 is the name of an operation, %2 of a number (&quot;Count&quot;), %3 and %4 what it was and is</extracomment>
        <translation>%1：%2 %3 → %4</translation>
    </message>
    <message>
        <source>Change %1</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>更改 %1</translation>
    </message>
    <message>
        <source>Change the order of %1</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>更改 %1 的顺序</translation>
    </message>
    <message>
        <source>Leave out %1</source>
        <extracomment>%1 is the name of a section that an operation made</extracomment>
        <translation>略去 %1</translation>
    </message>
    <message numerus="yes">
        <source>Leave out %n sections</source>
        <translation>
            <numerusform>略去 %n 个插片</numerusform>
        </translation>
    </message>
    <message>
        <source>Bring a left-out section back</source>
        <translation>恢复略去的插片</translation>
    </message>
    <message>
        <source>Cut %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>剪切 %1</translation>
    </message>
    <message numerus="yes">
        <source>Cut %n sections</source>
        <translation>
            <numerusform>剪切 %n 个插片</numerusform>
        </translation>
    </message>
    <message>
        <source>Paste %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>粘贴 %1</translation>
    </message>
    <message numerus="yes">
        <source>Paste %n sections</source>
        <translation>
            <numerusform>粘贴 %n 个插片</numerusform>
        </translation>
    </message>
    <message>
        <source>Keep dimension</source>
        <translation>保留尺寸</translation>
    </message>
    <message>
        <source>Delete dimension</source>
        <translation>删除尺寸</translation>
    </message>
    <message>
        <source>Make symmetric</source>
        <translation>变对称</translation>
    </message>
    <message>
        <source>Switch %1 on</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>启用 %1</translation>
    </message>
    <message>
        <source>Switch %1 off</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>关闭 %1</translation>
    </message>
    <message>
        <source>Bake %1</source>
        <extracomment>%1 is the name of an operation</extracomment>
        <translation>定型 %1</translation>
    </message>
    <message>
        <source>Detach %1</source>
        <extracomment>%1 is the name of a section that an operation made</extracomment>
        <translation>分离 %1</translation>
    </message>
    <message>
        <source>Remove holes of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>移除 %1 的孔</translation>
    </message>
    <message numerus="yes">
        <source>Remove holes of %n sections</source>
        <translation>
            <numerusform>移除 %n 个插片的孔</numerusform>
        </translation>
    </message>
    <message>
        <source>Shift planes of %1</source>
        <extracomment>%1 is the name of an operation, such as &quot;Slices&quot;</extracomment>
        <translation>偏移 %1 的平面</translation>
    </message>
    <message>
        <source>Change number of planes of %1</source>
        <extracomment>%1 is the name of an operation, such as &quot;Slices&quot;</extracomment>
        <translation>更改 %1 的平面数</translation>
    </message>
    <message>
        <source>Change spacing of planes of %1</source>
        <extracomment>%1 is the name of an operation, such as &quot;Slices&quot;</extracomment>
        <translation>更改 %1 的平面间距</translation>
    </message>
</context>
<context>
    <name>Suggestion</name>
    <message>
        <source>%1 is too small or too thin for sections that are %2 thick.</source>
        <extracomment>%1 is the name of a template, %2 a length</extracomment>
        <translation>%1 太小或太薄，不适合 %2 厚的插片。</translation>
    </message>
    <message>
        <source>No sections of %1 were found that hold each other and stand.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>没有为 %1 找到能互相固定并站稳的插片。</translation>
    </message>
    <message>
        <source>No further section of %1 was found that fits among those that are there.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>没有为 %1 找到还能加进现有插片之间的插片。</translation>
    </message>
    <message numerus="yes">
        <source>Only %n sections of %1 were found: any more would be in the way of these, or be held by none.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>
            <numerusform>只为 %1 找到 %n 个插片：再多就会挡住它们，或没有东西固定。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sections of %1 are the fewest that were found to stand.</source>
        <extracomment>%1 is the name of a template</extracomment>
        <translation>
            <numerusform>%n 个插片是找到的能让 %1 站稳的最少数量。</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 was lowered into the ground by %2, so that its sections stand on a flat foot.</source>
        <extracomment>%1 is the name of a template, %2 a length</extracomment>
        <translation>%1 已下沉到地面以下 %2，让它的插片有平底可站。</translation>
    </message>
    <message>
        <source>%1 was lowered into the ground by %2, and its sections have feet up to %3 high, so that they stand.</source>
        <extracomment>%1 is the name of a template, %2 and %3 are lengths</extracomment>
        <translation>%1 已下沉到地面以下 %2，它的插片加了最高 %3 的支脚，以便站稳。</translation>
    </message>
</context>
<context>
    <name>Template</name>
    <message>
        <source>It moves; only its first picture is shown.</source>
        <extracomment>of a picture</extracomment>
        <translation>这是动图；只显示第一帧。</translation>
    </message>
    <message numerus="yes">
        <source>%n texts were left out.</source>
        <extracomment>of a drawing</extracomment>
        <translation>
            <numerusform>略去了 %n 段文字。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pictures were left out.</source>
        <extracomment>of a drawing</extracomment>
        <translation>
            <numerusform>略去了 %n 张图片。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Values</name>
    <message>
        <source>A number, a name or a sum is missing.</source>
        <translation>缺少数字、名称或算式。</translation>
    </message>
    <message>
        <source>An expression has no more than %1 letters; this one is longer.</source>
        <translation>表达式最多 %1 个字符；这个更长。</translation>
    </message>
    <message>
        <source>At “%1” the expression has more than %2 numbers, names and signs.</source>
        <extracomment>numbers, names and signs such as +</extracomment>
        <translation>表达式在“%1”处的数字、名称和符号超过 %2 个。</translation>
    </message>
    <message>
        <source>At “%1” more than %2 parentheses or signs stand in each other.</source>
        <translation>在“%1”处嵌套的括号或符号超过 %2 层。</translation>
    </message>
    <message>
        <source>“%1” cannot be read here.</source>
        <translation>“%1”在这里无法识别。</translation>
    </message>
    <message>
        <source>Something is missing after “%1”.</source>
        <translation>“%1”后面缺了内容。</translation>
    </message>
    <message>
        <source>Something is missing before “%1”.</source>
        <translation>“%1”前面缺了内容。</translation>
    </message>
    <message>
        <source>Between “%1” and “%2” a sign is missing, such as + or *.</source>
        <translation>“%1”和“%2”之间缺少符号，例如 + 或 *。</translation>
    </message>
    <message>
        <source>The parenthesis at “%1” is not closed.</source>
        <translation>“%1”处的括号没有闭合。</translation>
    </message>
    <message>
        <source>After “%1” there is one closing parenthesis too many.</source>
        <translation>“%1”后面多了一个右括号。</translation>
    </message>
    <message>
        <source>The text at “%1” has no closing quote.</source>
        <translation>“%1”处的文字缺少右引号。</translation>
    </message>
    <message>
        <source>“%1” can be one number or two: write a point, or a blank after the comma.</source>
        <translation>“%1”可以是一个数，也可以是两个：请写小数点，或在逗号后加空格。</translation>
    </message>
    <message>
        <source>“%1” is a unit; a number belongs before it.</source>
        <translation>“%1”是单位；前面应有数字。</translation>
    </message>
    <message>
        <source>“%1” can be meant in two ways: put “%2” in parentheses.</source>
        <translation>“%1”有两种理解：请给“%2”加上括号。</translation>
    </message>
    <message>
        <source>“%1” is a second comparison; and(…; …) joins two of them.</source>
        <translation>“%1”是第二个比较；用 and(…; …) 把两个连起来。</translation>
    </message>
    <message>
        <source>There is no function named “%1”.</source>
        <translation>没有名为“%1”的函数。</translation>
    </message>
    <message>
        <source>“%1” takes %2 between its parentheses, not %3.</source>
        <translation>“%1”的括号里要有 %2 项，而不是 %3 项。</translation>
    </message>
    <message>
        <source>“%1” takes at least %2 between its parentheses, not %3.</source>
        <translation>“%1”的括号里至少要有 %2 项，而不是 %3 项。</translation>
    </message>
    <message>
        <source>“%1” takes at most %2 between its parentheses, not %3.</source>
        <translation>“%1”的括号里最多有 %2 项，而不是 %3 项。</translation>
    </message>
    <message>
        <source>There is no value named “%1”.</source>
        <translation>没有名为“%1”的参数。</translation>
    </message>
    <message>
        <source>“%1” is the thickness of the stock; there is no single stock here.</source>
        <translation>“%1”是材料的厚度；这里不止一种材料。</translation>
    </message>
    <message>
        <source>“%1” is %2, so it cannot have a unit of its own.</source>
        <translation>“%1”是%2，所以不能再带单位。</translation>
    </message>
    <message>
        <source>“%1” is %2 and “%3” is %4; only what is alike can be added or compared.</source>
        <extracomment>%2 and %4: such as “a length”</extracomment>
        <translation>“%1”是%2，“%3”是%4；同类的才能相加或比较。</translation>
    </message>
    <message>
        <source>“%1” is %2; nothing can be calculated with it.</source>
        <translation>“%1”是%2；不能用来计算。</translation>
    </message>
    <message>
        <source>“%1” is %2; what is needed here is %3.</source>
        <extracomment>%2 and %3: such as “a length”</extracomment>
        <translation>“%1”是%2；这里需要%3。</translation>
    </message>
    <message>
        <source>“%1” is %2; it can only be raised to a small whole number, such as 2, not to “%3”.</source>
        <translation>“%1”是%2；指数只能是 2 之类的小整数，不能是“%3”。</translation>
    </message>
    <message>
        <source>“%1” multiplies too many lengths, angles or masses.</source>
        <translation>“%1”相乘的长度、角度或质量太多。</translation>
    </message>
    <message>
        <source>“%1” is %2, which has no square root.</source>
        <translation>“%1”是%2，不能开平方。</translation>
    </message>
    <message>
        <source>“%1” is 0, and nothing can be divided by 0.</source>
        <translation>“%1”等于 0，不能除以 0。</translation>
    </message>
    <message>
        <source>“%1” is negative and has no square root.</source>
        <translation>“%1”是负数，不能开平方。</translation>
    </message>
    <message>
        <source>The tangent of “%1” is infinite.</source>
        <translation>“%1”的正切是无穷大。</translation>
    </message>
    <message>
        <source>“%1” is not between −1 and 1, so it belongs to no angle.</source>
        <translation>“%1”不在 −1 和 1 之间，所以没有对应的角度。</translation>
    </message>
    <message>
        <source>“%1” is no number.</source>
        <translation>“%1”不是数。</translation>
    </message>
    <message>
        <source>“%1” is not above 0, and nothing can be rounded to steps of that.</source>
        <translation>“%1”不大于 0，不能按这样的步长取整。</translation>
    </message>
    <message>
        <source>“%1” is too large.</source>
        <translation>“%1”太大。</translation>
    </message>
    <message>
        <source>“%1” is %2, not a whole number; round, floor or ceil make it one.</source>
        <extracomment>%2: a number</extracomment>
        <translation>“%1”等于 %2，不是整数；用 round、floor 或 ceil 可变成整数。</translation>
    </message>
    <message>
        <source>“%1” is %2; it has to be at least %3.</source>
        <extracomment>%2 and %3: lengths, masses, angles or numbers</extracomment>
        <translation>“%1”等于 %2；至少为 %3。</translation>
    </message>
    <message>
        <source>“%1” is %2; it can be at most %3.</source>
        <translation>“%1”等于 %2；最多为 %3。</translation>
    </message>
    <message>
        <source>“%1” is “%2”, which is none of the choices.</source>
        <translation>“%1”等于“%2”，不在可选项中。</translation>
    </message>
    <message>
        <source>“%1” makes a text of more than %2 letters.</source>
        <translation>“%1”得到的文字超过 %2 个字符。</translation>
    </message>
    <message>
        <source>This value is made of itself: %1.</source>
        <extracomment>%1: such as “a → b → a”</extracomment>
        <translation>这个参数依赖它自己：%1。</translation>
    </message>
    <message>
        <source>This value is made of “%1”, which has none at the moment.</source>
        <translation>这个参数依赖“%1”，而它目前没有值。</translation>
    </message>
    <message>
        <source>Two values are named “%1”.</source>
        <translation>有两个参数名为“%1”。</translation>
    </message>
    <message>
        <source>“%1” is no name; a name is a letter, then letters, digits and _, %2 at most.</source>
        <translation>“%1”不是名称；名称以字母开头，后面是字母、数字和 _，最多 %2 个。</translation>
    </message>
    <message>
        <source>“%1” cannot be a name, as it means something in expressions.</source>
        <translation>“%1”不能作名称，因为它在表达式中有含义。</translation>
    </message>
    <message>
        <source>This value is not there any more.</source>
        <translation>这个参数已经不在了。</translation>
    </message>
    <message>
        <source>The brace at “%1” is not closed.</source>
        <translation>“%1”处的花括号没有闭合。</translation>
    </message>
    <message>
        <source>a plain number</source>
        <translation>普通数字</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>整数</translation>
    </message>
    <message>
        <source>a length</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>an area</source>
        <translation>面积</translation>
    </message>
    <message>
        <source>a volume</source>
        <translation>体积</translation>
    </message>
    <message>
        <source>an angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>a mass</source>
        <translation>质量</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>文字</translation>
    </message>
    <message>
        <source>a yes or no</source>
        <translation>是或否</translation>
    </message>
    <message>
        <source>no length, angle, mass or plain number</source>
        <extracomment>of what lengths, angles and masses are multiplied and divided to: “1/width” is …</extracomment>
        <translation>长度、角度、质量和普通数字之外的量</translation>
    </message>
</context>
<context>
    <name>fff::SectionNames</name>
    <message>
        <source>Section %1</source>
        <extracomment>what the program calls a section that nobody has named; %1 is its number</extracomment>
        <translation>插片 %1</translation>
    </message>
    <message>
        <source>Sections %1</source>
        <extracomment>several that nobody has named; %1 is such as &quot;70–73&quot; or &quot;2, 5–8&quot;</extracomment>
        <translation>插片 %1</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <extracomment>the end of a list of names</extracomment>
        <translation>%1 和 %2</translation>
    </message>
</context>
<context>
    <name>fff::cli</name>
    <message>
        <source>There is no stock &quot;%1&quot;. Choose one of the file, or of the list of materials, such as Birch plywood, Acrylic or Card.</source>
        <translation>没有材料“%1”。请选择文件中的一种，或材料列表中的一种，例如 Birch plywood、Acrylic 或 Card。</translation>
    </message>
    <message>
        <source>--thickness %1 leaves no room for slits in the stock %2: its clearance is %3 mm.</source>
        <translation>--thickness %1 使材料 %2 的插槽没有宽度：它的间隙为 %3 mm。</translation>
    </message>
    <message>
        <source>--%1 does not fit the stock %2, which is %3 mm thick.</source>
        <translation>--%1 不适合材料 %2，它厚 %3 mm。</translation>
    </message>
    <message>
        <source>a %1 file</source>
        <translation>%1 文件</translation>
    </message>
    <message>
        <source>a %2 %1 file</source>
        <translation>%2 的 %1 文件</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 或 %2</translation>
    </message>
    <message>
        <source>%1; or %2</source>
        <translation>%1；或 %2</translation>
    </message>
    <message>
        <source>; </source>
        <translation>; </translation>
    </message>
    <message>
        <source>Usage: %1</source>
        <translation>用法：%1</translation>
    </message>
    <message>
        <source>Shows this help.</source>
        <translation>显示本帮助。</translation>
    </message>
    <message>
        <source>No file was given.</source>
        <translation>没有给出文件。</translation>
    </message>
    <message>
        <source>Too many files: %1</source>
        <translation>文件太多：%1</translation>
    </message>
    <message>
        <source>Gives a named value of the model another number, or all that a preset sets; may be repeated.</source>
        <translation>给模型中有名称的参数换一个数，或采用预设的全部设置；可重复使用。</translation>
    </message>
    <message>
        <source>Thickness of every stock.</source>
        <translation>所有材料的厚度。</translation>
    </message>
    <message>
        <source>Cuts every section from this stock, or from that of a .fff file.</source>
        <translation>所有插片都用这种材料切割，或用某个 .fff 文件中的材料。</translation>
    </message>
    <message>
        <source>Full width that the machine removes.</source>
        <translation>机器切掉的全宽。</translation>
    </message>
    <message>
        <source>Play added to slits; less than 0 for a press fit.</source>
        <translation>插槽的附加间隙；小于 0 为过盈配合。</translation>
    </message>
    <message>
        <source>Says of each thing in the file that was corrected where.</source>
        <translation>逐条说明文件中哪里做了修正。</translation>
    </message>
    <message>
        <source>--%1: found &quot;%2&quot;, expected %3.</source>
        <translation>--%1：读到“%2”，应为：%3。</translation>
    </message>
    <message>
        <source>--%1: found &quot;%2&quot;, expected a number from %3 to %4.</source>
        <translation>--%1：读到“%2”，应为 %3 到 %4 的数。</translation>
    </message>
    <message>
        <source>--sheet: found &quot;%1&quot;, expected width x height in mm, such as 600x400.</source>
        <translation>--sheet：读到“%1”，应为以 mm 为单位的宽 x 高，例如 600x400。</translation>
    </message>
    <message>
        <source>--set: %1</source>
        <translation>--set：%1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>%1 is a file&apos;s name, %2 a sentence about what is in it
----------
%1 are names of stocks, %2 is a sentence</extracomment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Push all %1 slats together: what their width is less than %2 mm, divided by %1, is the kerf.</source>
        <translation>把全部 %1 根条推到一起：它们的宽度比 %2 mm 少的部分除以 %1，就是切缝。</translation>
    </message>
    <message>
        <source>Bridges that hold each part in its sheet, and their width in mm, such as 3:0.4 (none).</source>
        <translation>把每个零件留在板材上的微连个数及其以 mm 为单位的宽度，例如 3:0.4（无）。</translation>
    </message>
    <message>
        <source>Begins and ends each cut so far beside its line, in the waste (0).</source>
        <translation>每次切割都在切线旁这么远的废料中开始和结束（0）。</translation>
    </message>
    <message>
        <source>Cuts edges of two parts that lie on each other once; with --spacing 0.</source>
        <translation>两个零件贴在一起的边只切一次；与 --spacing 0 一起使用。</translation>
    </message>
    <message>
        <source>Writes a test piece in place of the parts: slits of numbered widths, and slats that tell the kerf.</source>
        <translation>写出一个试片来代替零件：带编号、宽度不同的插槽，以及能测出切缝的条。</translation>
    </message>
    <message>
        <source>--tabs: found &quot;%1&quot;, expected a number from 0 to %2, then a colon and a width from %3 to %4.</source>
        <translation>--tabs：读到“%1”，应为 0 到 %2 的数，再加冒号和 %3 到 %4 的宽度。</translation>
    </message>
    <message>
        <source>--%1: found &quot;%2&quot;, expected a number from 0 to %3.</source>
        <translation>--%1：读到“%2”，应为 0 到 %3 的数。</translation>
    </message>
    <message>
        <source>%1 × %2 mm</source>
        <translation>%1 × %2 mm</translation>
    </message>
    <message>
        <source>Step %1: start with part %2</source>
        <translation>第 %1 步：从零件 %2 开始</translation>
    </message>
    <message>
        <source>Step %1: start a group of its own with part %2</source>
        <translation>第 %1 步：从零件 %2 开始另拼一组</translation>
    </message>
    <message>
        <source>Step %1: part %2</source>
        <translation>第 %1 步：零件 %2</translation>
    </message>
    <message>
        <source>Step %1: parts %2 as one, joining what steps %3 and %4 have put together</source>
        <translation>第 %1 步：零件 %2 作为整体，把第 %3 步和第 %4 步拼好的部分接起来</translation>
    </message>
    <message>
        <source>Sections: %1</source>
        <translation>插片：%1</translation>
    </message>
    <message>
        <source>Joints: %1</source>
        <translation>接头：%1</translation>
    </message>
    <message>
        <source>%1 and %2 meet, but no slit lets them slide together.</source>
        <translation>%1 和 %2 相交，但没有插槽能让它们插到一起。</translation>
    </message>
    <message>
        <source>All sections hold together.</source>
        <translation>所有插片连成一体。</translation>
    </message>
    <message>
        <source>a part of %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 的一部分</translation>
    </message>
    <message>
        <source>Not connected to the rest: %1</source>
        <translation>没有与其余部分相连：%1</translation>
    </message>
    <message>
        <source>Size %1 × %2 × %3 mm (width, height, depth)</source>
        <translation>尺寸 %1 × %2 × %3 mm（宽、高、深）</translation>
    </message>
    <message>
        <source>Mass %1 g</source>
        <translation>质量 %1 g</translation>
    </message>
    <message>
        <source>Stock %1, %2 mm, sheets of %3</source>
        <translation>材料 %1，%2 mm，板材 %3</translation>
    </message>
    <message>
        <source>Part %1: %2, %3</source>
        <translation>零件 %1：%2，%3</translation>
    </message>
    <message>
        <source>, joints %1</source>
        <translation>，接头 %1</translation>
    </message>
    <message>
        <source>Nothing to cut: the model has no sections.</source>
        <translation>没有可切割的：模型没有插片。</translation>
    </message>
    <message>
        <source>Nothing to cut: the slits leave nothing of any section.</source>
        <translation>没有可切割的：插槽把所有插片都切得什么都不剩。</translation>
    </message>
    <message>
        <source>-o is missing: give the file to write.</source>
        <translation>缺少 -o：请给出要写入的文件。</translation>
    </message>
    <message>
        <source>-o: a file needs a name.</source>
        <translation>-o：文件需要一个名称。</translation>
    </message>
    <message>
        <source>%1: this kind of file cannot be written; expected %2.</source>
        <translation>%1：不能写这种文件；应为 %2。</translation>
    </message>
    <message>
        <source>Puts a mesh, a picture or a drawing (SVG) beside the model, its largest extent of this size in mm; may be given several times.</source>
        <translation>在模型旁放一个网格、图片或图稿（SVG），最大尺寸为这个 mm 数；可给出多次。</translation>
    </message>
    <message>
        <source>--template: found &quot;%1&quot;, expected a file, or a file and its size in mm, such as ball.stl@80.</source>
        <translation>--template：读到“%1”，应为文件，或文件及其以 mm 为单位的大小，例如 ball.stl@80。</translation>
    </message>
    <message>
        <source>The .fff file to write; - is standard output.</source>
        <translation>要写入的 .fff 文件；- 表示标准输出。</translation>
    </message>
    <message>
        <source>Scales the mesh to this largest extent; without it as large as its file says, else 254.</source>
        <translation>把网格缩放到这个最大尺寸；不给则按文件中的大小，否则为 254。</translation>
    </message>
    <message>
        <source>--%1: found &quot;%2&quot;, expected a whole number from %3 to %4.</source>
        <translation>--%1：读到“%2”，应为 %3 到 %4 的整数。</translation>
    </message>
    <message>
        <source>%1: this item is too large for the strip.</source>
        <extracomment>%1 is a file and a place in it</extracomment>
        <translation>%1：这个工件太大，条带放不下。</translation>
    </message>
    <message>
        <source>Length: %1</source>
        <translation>长度：%1</translation>
    </message>
    <message>
        <source>Density: %1 %</source>
        <translation>密度：%1 %</translation>
    </message>
    <message>
        <source>Parts: %1, sheets: %2</source>
        <translation>零件：%1，板材：%2</translation>
    </message>
    <message>
        <source>%1 × %2 mm, %3: %4 parts, %5 % covered</source>
        <extracomment>A sheet&apos;s size, its stock, how many parts lie on it, and how much of it they cover</extracomment>
        <translation>%1 × %2 mm，%3：%4 个零件，覆盖 %5 %</translation>
    </message>
    <message>
        <source>%1: a part is too large for its sheet.</source>
        <translation>%1：有个零件太大，它的板材放不下。</translation>
    </message>
    <message>
        <source>--sheets: found &quot;%1&quot;, expected groups or files.</source>
        <translation>--sheets：读到“%1”，应为 groups 或 files。</translation>
    </message>
    <message>
        <source>--machine: there is no machine &quot;%1&quot;; expected %2, or a .json file.</source>
        <translation>--machine：没有机器“%1”；应为 %2，或一个 .json 文件。</translation>
    </message>
    <message>
        <source>--machine: %1</source>
        <translation>--machine：%1</translation>
    </message>
    <message>
        <source>--sheets files needs a name: standard output is one file only.</source>
        <translation>--sheets files 需要文件名：标准输出只有一个文件。</translation>
    </message>
    <message>
        <source>Slits are drawn %1 mm wide.</source>
        <translation>插槽画成 %1 mm 宽。</translation>
    </message>
    <message>
        <source>Slits are drawn %1 mm wide (%2 − %3 kerf).</source>
        <extracomment>%2 is the width that is wanted, which is larger by the kerf %3</extracomment>
        <translation>插槽画成 %1 mm 宽（%2 − 切缝 %3）。</translation>
    </message>
    <message>
        <source>Sheets of an earlier export are still there: %1</source>
        <translation>上次导出的板材文件还在：%1</translation>
    </message>
    <message>
        <source>Patches: %1, triangles: %2.</source>
        <translation>曲面片：%1，三角形：%2。</translation>
    </message>
    <message>
        <source>Places that stay open: %1</source>
        <translation>保持开口的地方：%1</translation>
    </message>
    <message>
        <source>%1: %2 m of cuts, about %3 min.</source>
        <extracomment>%1 is a machine, %2 and %3 are numbers</extracomment>
        <translation>%1：切割 %2 m，约 %3 分钟。</translation>
    </message>
    <message>
        <source>Sheets are larger than its bed of %1 x %2 mm; choose others by --sheet.</source>
        <extracomment>%1 x %2 is the size of a bed</extracomment>
        <translation>板材比它 %1 x %2 mm 的台面大；请用 --sheet 选择别的板材。</translation>
    </message>
    <message>
        <source>Parts: %1, sheets: %2, %3 % used.</source>
        <translation>零件：%1，板材：%2，利用率 %3 %。</translation>
    </message>
    <message>
        <source>The file to write; - is standard output.</source>
        <translation>要写入的文件；- 表示标准输出。</translation>
    </message>
    <message>
        <source>%1; needed if the file&apos;s name does not tell.</source>
        <translation>%1；文件名看不出时需要。</translation>
    </message>
    <message>
        <source>Leaves out the 100 mm bar beside the sheets.</source>
        <translation>不画板材旁的 100 mm 标尺。</translation>
    </message>
    <message>
        <source>From the sheet&apos;s edge to the nearest cut (5).</source>
        <translation>板材边缘到最近切线的距离（5）。</translation>
    </message>
    <message>
        <source>Between neighbouring cuts (2).</source>
        <translation>相邻切线之间的距离（2）。</translation>
    </message>
    <message>
        <source>Quarter turns only, for sheets with a grain.</source>
        <translation>只转四分之一圈，用于有纹理的板材。</translation>
    </message>
    <message>
        <source>Lays parts by their true outlines, searching for so many seconds; 0 takes the first layout (by their boxes).</source>
        <translation>按零件的真实轮廓排版，搜索这么多秒；0 表示采用第一个排版（按外框）。</translation>
    </message>
    <message>
        <source>groups: one SVG with a group a sheet; files: OUT-1.svg, OUT-2.svg and so on (groups).</source>
        <translation>groups：一个 SVG，每张板材一组；files：OUT-1.svg、OUT-2.svg 等（groups）。</translation>
    </message>
    <message>
        <source>The machine that cuts, for its colours, speeds and G-code: %1; or a .json file with one&apos;s own (generic).</source>
        <translation>用来切割的机器，决定颜色、速度和 G-code：%1；或描述自己机器的 .json 文件（generic）。</translation>
    </message>
    <message>
        <source>Writes the form that the sections suggest, as a surface (%1), in place of the solids.</source>
        <extracomment>%1 are ends of names, such as &quot;obj or stl&quot;</extracomment>
        <translation>写出插片勾勒出的形体，作为曲面（%1），代替实体。</translation>
    </message>
    <message>
        <source>With -o - the format is missing: --format %1.</source>
        <translation>使用 -o - 时缺少格式：--format %1。</translation>
    </message>
    <message>
        <source>--skin: this kind of file cannot hold it; expected %1.</source>
        <translation>--skin：这种文件存不了；应为 %1。</translation>
    </message>
    <message>
        <source>--coupon: this kind of file cannot hold it; expected %1.</source>
        <translation>--coupon：这种文件存不了；应为 %1。</translation>
    </message>
    <message>
        <source>Pixels of the picture (1280x800).</source>
        <translation>图片的像素尺寸（1280x800）。</translation>
    </message>
    <message>
        <source>iso1 to iso4, front, right, top, left, back, bottom, or fit: the front again (iso1).</source>
        <translation>iso1 到 iso4、front、right、top、left、back、bottom，或 fit：仍从前面看（iso1）。</translation>
    </message>
    <message>
        <source>--size: found &quot;%1&quot;, expected width x height in pixels up to %2, such as 1280x800.</source>
        <translation>--size：读到“%1”，应为以像素为单位的宽 x 高，最大 %2，例如 1280x800。</translation>
    </message>
    <message>
        <source>--view: found &quot;%1&quot;, expected one of %2.</source>
        <translation>--view：读到“%1”，应为以下之一：%2。</translation>
    </message>
    <message>
        <source>Stands.</source>
        <translation>能站稳。</translation>
    </message>
    <message>
        <source>Falls over.</source>
        <translation>会翻倒。</translation>
    </message>
    <message>
        <source>Falls over: it has only a single line to stand on.</source>
        <translation>会翻倒：它只有一条线可站。</translation>
    </message>
    <message>
        <source>A part of it has nothing to stand on.</source>
        <translation>它有一部分没有东西可站。</translation>
    </message>
    <message>
        <source>It is not on the ground.</source>
        <translation>它不在地面上。</translation>
    </message>
    <message>
        <source>Slides away over the ground.</source>
        <translation>会在地面上滑走。</translation>
    </message>
    <message>
        <source>Its parts move against each other.</source>
        <translation>它的零件会相互移动。</translation>
    </message>
    <message>
        <source>Holds.</source>
        <translation>撑得住。</translation>
    </message>
    <message>
        <source>Barely holds: it may crack in a corner.</source>
        <translation>勉强撑住：角上可能开裂。</translation>
    </message>
    <message>
        <source>Breaks.</source>
        <translation>会断裂。</translation>
    </message>
    <message>
        <source>A joint is pulled open.</source>
        <translation>有接头被拉开。</translation>
    </message>
    <message>
        <source>Strength is worked out only for what stands still.</source>
        <translation>只对静止的模型计算强度。</translation>
    </message>
    <message>
        <source>Not rated: the strength of a stock is not known.</source>
        <translation>未评定：有种材料的强度未知。</translation>
    </message>
    <message>
        <source>Whether it holds could not be worked out.</source>
        <translation>无法算出是否撑得住。</translation>
    </message>
    <message>
        <source>Would stand %1.</source>
        <extracomment>%1 is such as &quot;if it held together&quot;</extracomment>
        <translation>%1，本可站稳。</translation>
    </message>
    <message>
        <source>Too weak: it holds, but not with the safety that is asked for.</source>
        <translation>不够结实：撑得住，但达不到要求的安全系数。</translation>
    </message>
    <message>
        <source>Would hold %1.</source>
        <extracomment>%1 is such as &quot;if it held together&quot;</extracomment>
        <translation>%1，本可撑住。</translation>
    </message>
    <message>
        <source>%1 presses on the ground with %2 N.</source>
        <translation>%1 对地面的压力为 %2 N。</translation>
    </message>
    <message>
        <source>Joint %1–%2 is pulled open with %3 N: glue it, or flip its slits.</source>
        <translation>接头 %1–%2 被 %3 N 的力拉开：请粘牢，或翻转它的插槽。</translation>
    </message>
    <message>
        <source>How %1 bends could not be worked out; it is treated as rigid.</source>
        <translation>无法算出 %1 怎样弯曲；按刚性处理。</translation>
    </message>
    <message>
        <source>How sections bend could not be worked out; they are treated as rigid.</source>
        <translation>无法算出插片怎样弯曲；按刚性处理。</translation>
    </message>
    <message>
        <source>Joints can share the load in more than one way (indeterminate, %1); the worst way counts.</source>
        <translation>接头分担载荷的方式不止一种（超静定，%1）；按最不利的计。</translation>
    </message>
    <message>
        <source>The stress in %1 could not be worked out.</source>
        <translation>无法算出 %1 中的应力。</translation>
    </message>
    <message>
        <source>%1 is not rated: the strength of its stock is not known.</source>
        <translation>%1 未评定：它的材料强度未知。</translation>
    </message>
    <message>
        <source>A push of %1 N misses the material of %2; the nearest place takes it.</source>
        <translation>%1 N 的推力落在 %2 没有材料的地方；由最近的位置承受。</translation>
    </message>
    <message>
        <source>A weight of %1 misses the material of %2; the nearest place takes it.</source>
        <translation>%1 的重物落在 %2 没有材料的地方；由最近的位置承受。</translation>
    </message>
    <message>
        <source>%1 in all</source>
        <translation>总共 %1</translation>
    </message>
    <message>
        <source>%1 N in all</source>
        <translation>总共 %1 N</translation>
    </message>
    <message>
        <source>%1 times the load</source>
        <translation>%1 倍载荷</translation>
    </message>
    <message>
        <source>Weakest in %1: %2 of its stock&apos;s strength in the neck, %3 in the corner.</source>
        <translation>最弱的是 %1：最窄处达到材料强度的 %2，角上达到 %3。</translation>
    </message>
    <message>
        <source>Bends %1 mm, most of all %2.</source>
        <translation>弯曲 %1 mm，%2 弯得最多。</translation>
    </message>
    <message>
        <source>May crack from %1.</source>
        <translation>从 %1 起可能开裂。</translation>
    </message>
    <message>
        <source>Breaks at %1.</source>
        <translation>在 %1 时断裂。</translation>
    </message>
    <message>
        <source>Weighs %1 N with everything on it.</source>
        <translation>连同上面的一切重 %1 N。</translation>
    </message>
    <message>
        <source>found &quot;%1&quot;, expected NAME=VALUE, such as width=400.</source>
        <translation>读到“%1”，应为 名称=数值，例如 width=400。</translation>
    </message>
    <message>
        <source>found &quot;%1&quot;, expected NAME=VALUE, such as width=400, or a preset: %2.</source>
        <extracomment>%2 are names of presets of values: &quot;A5 or A4&quot;</extracomment>
        <translation>读到“%1”，应为 名称=数值，例如 width=400，或一个预设：%2。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; can be %2 or %3; please write one of these.</source>
        <extracomment>all are ways to write numbers: &quot;1,125&quot;, &quot;1.125&quot; and &quot;1125&quot;</extracomment>
        <translation>“%1”可以是 %2 或 %3；请写其中之一。</translation>
    </message>
    <message>
        <source>the model has no values with names.</source>
        <translation>模型没有带名称的参数。</translation>
    </message>
    <message>
        <source>there is no value &quot;%1&quot;; expected %2.</source>
        <translation>没有参数“%1”；应为 %2。</translation>
    </message>
    <message>
        <source>No value that others can adjust has a range and is used.</source>
        <translation>别人可以调整的参数中，没有既有范围又用到的。</translation>
    </message>
    <message>
        <source>Tried: %1 of %2 corners of the ranges, %3 variants between them.</source>
        <translation>试了：范围的 %2 个端点组合中的 %1 个，以及其间的 %3 个变体。</translation>
    </message>
    <message>
        <source>All of them are good.</source>
        <translation>全部都好。</translation>
    </message>
    <message>
        <source>%1 of %2 fail:</source>
        <translation>%2 个中有 %1 个不行：</translation>
    </message>
    <message>
        <source>Where:</source>
        <translation>位置：</translation>
    </message>
    <message>
        <source>Faces: %1, shells: %2</source>
        <translation>面：%1，壳：%2</translation>
    </message>
    <message>
        <source>The plane does not cut it.</source>
        <translation>平面没有截到它。</translation>
    </message>
    <message>
        <source>Hole: %1 mm², %2 points</source>
        <translation>孔：%1 mm²，%2 个点</translation>
    </message>
    <message>
        <source>Loop: %1 mm², %2 points</source>
        <translation>闭合曲线：%1 mm²，%2 个点</translation>
    </message>
    <message>
        <source>Area: %1 mm²</source>
        <translation>面积：%1 mm²</translation>
    </message>
    <message>
        <source>A point of the plane and its normal, six numbers with commas.</source>
        <translation>平面上的一点及其法线，用逗号分隔的六个数。</translation>
    </message>
    <message>
        <source>Scales the mesh to this largest extent and stands it on the ground first.</source>
        <translation>先把网格缩放到这个最大尺寸，并放到地面上。</translation>
    </message>
    <message>
        <source>Prints JSON, for other programs.</source>
        <translation>输出 JSON，供其他程序使用。</translation>
    </message>
    <message>
        <source>--plane is missing.</source>
        <translation>缺少 --plane。</translation>
    </message>
    <message>
        <source>--plane: found &quot;%1&quot;, expected six numbers, of which the last three are a direction.</source>
        <translation>--plane：读到“%1”，应为六个数，后三个是方向。</translation>
    </message>
    <message>
        <source>No fingers where sheets meet at less than 30° or more than 150°: %1</source>
        <translation>板材相交角度小于 30° 或大于 150° 处没有指接：%1</translation>
    </message>
    <message>
        <source>No fingers where one sheet goes past the other or does not reach it: %1</source>
        <translation>一张板材越过另一张或够不到它的地方没有指接：%1</translation>
    </message>
    <message>
        <source>No fingers on edges that are too short for three of them: %1</source>
        <translation>短得放不下三个指的边没有指接：%1</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <extracomment>%1 and %2 are names of sections that share an edge</extracomment>
        <translation>%1 和 %2</translation>
    </message>
    <message>
        <source>A sheet of %1 mm does not fold, expected at most %2 mm; --stock chooses another.</source>
        <translation>%1 mm 的板材折不了，应为最多 %2 mm；用 --stock 换一种。</translation>
    </message>
    <message>
        <source>%1: it has %2 flat pieces, expected at most %3; --faces makes them fewer.</source>
        <translation>%1：它有 %2 个平块，应为最多 %3 个；用 --faces 可减少。</translation>
    </message>
    <message>
        <source>%1: no flat piece of it is large enough for a section; --size makes it larger.</source>
        <translation>%1：没有足够大的平块可做插片；用 --size 可放大。</translation>
    </message>
    <message>
        <source>Nets: %1, folds: %2, seams: %3</source>
        <translation>展开图：%1，折线：%2，接缝：%3</translation>
    </message>
    <message>
        <source>Simplifies the mesh to this many triangles first; those that are flat together are one piece.</source>
        <translation>先把网格简化到这么多三角形；处在同一平面上的合为一块。</translation>
    </message>
    <message>
        <source>Nets to fold along scored lines, of sheet up to 3 mm, instead of flat sheets.</source>
        <translation>生成可沿刻线折叠的展开图，板材最厚 3 mm，代替平板。</translation>
    </message>
    <message>
        <source>With --unfold: width of the flaps to glue; 8 mm for sheet up to 1.5 mm, else 0 mm.</source>
        <translation>与 --unfold 一起：粘贴边的宽度；板材不超过 1.5 mm 时为 8 mm，否则为 0 mm。</translation>
    </message>
    <message>
        <source>--flap is of --unfold.</source>
        <translation>--flap 属于 --unfold。</translation>
    </message>
    <message>
        <source>Pieces too small for a section: %1</source>
        <translation>太小、做不成插片的块：%1</translation>
    </message>
    <message>
        <source>Sections: %1, joints: %2</source>
        <translation>插片：%1，接头：%2</translation>
    </message>
    <message>
        <source>How long to search (10); 0 takes the first layout.</source>
        <translation>搜索多少秒（10）；0 表示采用第一个排版。</translation>
    </message>
    <message>
        <source>Another number gives another layout, the same one the same.</source>
        <translation>换个数字，得到别的排版；数字相同，排版相同。</translation>
    </message>
    <message>
        <source>How parts may be turned: none, 180, 90 or free.</source>
        <translation>零件可以怎样转：none、180、90 或 free。</translation>
    </message>
    <message>
        <source>From the sheet&apos;s edge to the nearest cut.</source>
        <translation>板材边缘到最近切线的距离。</translation>
    </message>
    <message>
        <source>Between neighbouring cuts.</source>
        <translation>相邻切线之间的距离。</translation>
    </message>
    <message>
        <source>--rotations: found &quot;%1&quot;, expected none, 180, 90 or free.</source>
        <translation>--rotations：读到“%1”，应为 none、180、90 或 free。</translation>
    </message>
    <message>
        <source>The model has no operations.</source>
        <translation>模型没有操作。</translation>
    </message>
    <message>
        <source>1 section</source>
        <translation>1 个插片</translation>
    </message>
    <message>
        <source>off</source>
        <translation>关</translation>
    </message>
    <message>
        <source>Prints JSON, for other programs; steps are counted from 0.</source>
        <translation>输出 JSON，供其他程序使用；步骤从 0 开始计数。</translation>
    </message>
    <message>
        <source>Largest distance between chords and curves (0.01).</source>
        <translation>弦与曲线的最大距离（0.01）。</translation>
    </message>
    <message>
        <source>%1: this kind of file cannot be written; expected .png.</source>
        <translation>%1：不能写这种文件；应为 .png。</translation>
    </message>
    <message>
        <source>--show: found &quot;%1&quot;, expected labels, checks, stress, forces, skin, or several separated by commas.</source>
        <translation>--show：读到“%1”，应为 labels、checks、stress、forces、skin，或用逗号分隔的几个。</translation>
    </message>
    <message>
        <source>%1: no forces are shown; it does not stand, or they could not be worked out. &quot;check&quot; says why.</source>
        <translation>%1：没有显示力；模型站不稳，或无法算出。原因见“check”。</translation>
    </message>
    <message>
        <source>The PNG file to write; - is standard output.</source>
        <translation>要写入的 PNG 文件；- 表示标准输出。</translation>
    </message>
    <message>
        <source>labels: the sections&apos; names; checks: outlines sections with a problem; stress: the weakest cross-sections; forces: what feet and joints carry; skin: the form that the sections suggest.</source>
        <translation>labels：插片的名称；checks：标出有问题的插片；stress：最弱的截面；forces：支脚和接头承受的力；skin：插片勾勒出的形体。</translation>
    </message>
    <message>
        <source>Stress by finite elements, in colours all over the sections; takes seconds.</source>
        <translation>用有限元计算应力，以颜色显示在整个插片上；需要几秒。</translation>
    </message>
    <message>
        <source>A picture needs a display with OpenGL 3.3; there is none.</source>
        <translation>生成图片需要支持 OpenGL 3.3 的显示设备；这里没有。</translation>
    </message>
    <message>
        <source>The picture could not be written as a PNG file.</source>
        <translation>图片无法写成 PNG 文件。</translation>
    </message>
    <message>
        <source>The model to start from; without it a new one.</source>
        <translation>作为起点的模型；不给则新建。</translation>
    </message>
    <message>
        <source>--along: found &quot;%1&quot;, expected X, Y, Z, XY, XZ, YZ or radial.</source>
        <translation>--along：读到“%1”，应为 X、Y、Z、XY、XZ、YZ 或 radial。</translation>
    </message>
    <message>
        <source>--count and --spacing were both given; expected one of them.</source>
        <translation>同时给出了 --count 和 --spacing；应只给一个。</translation>
    </message>
    <message>
        <source>--spacing: planes around an axis have none; expected --count.</source>
        <translation>--spacing：绕轴的平面没有间距；应为 --count。</translation>
    </message>
    <message>
        <source>The axes that planes are across: X, Y, Z, two of them for a grid, or radial: around the upright axis (XZ).</source>
        <translation>平面所垂直的轴：X、Y、Z，两个轴则构成格栅，或 radial：绕竖直轴（XZ）。</translation>
    </message>
    <message>
        <source>Planes in each direction (6).</source>
        <translation>每个方向的平面数（6）。</translation>
    </message>
    <message>
        <source>From plane to plane.</source>
        <translation>平面之间的间距。</translation>
    </message>
    <message>
        <source>%1: no plane cuts a section of it that is large enough.</source>
        <translation>%1：没有平面能从中切出足够大的插片。</translation>
    </message>
    <message>
        <source>--size is for .png; a PDF has the size of its paper.</source>
        <translation>--size 用于 .png；PDF 的尺寸就是纸张尺寸。</translation>
    </message>
    <message>
        <source>--paper is for .pdf.</source>
        <translation>--paper 用于 .pdf。</translation>
    </message>
    <message>
        <source>--paper: found &quot;%1&quot;, expected a4 or letter.</source>
        <translation>--paper：读到“%1”，应为 a4 或 letter。</translation>
    </message>
    <message>
        <source>Step %1 of %2</source>
        <translation>第 %1 步，共 %2 步</translation>
    </message>
    <message>
        <source>a4 or letter (by default as is usual in your country).</source>
        <translation>a4 或 letter（默认按你所在国家的习惯）。</translation>
    </message>
    <message>
        <source>How many sections (8).</source>
        <translation>插片的数量（8）。</translation>
    </message>
    <message>
        <source>Another number gives other sections (1).</source>
        <translation>换个数字，得到别的插片（1）。</translation>
    </message>
    <message>
        <source>Presets: %1. It is set to %2.</source>
        <extracomment>%1 are names of presets of values, %2 is the one that is set</extracomment>
        <translation>预设：%1。当前为 %2。</translation>
    </message>
    <message>
        <source>Presets: %1</source>
        <translation>预设：%1</translation>
    </message>
    <message>
        <source>The model has no values with names.</source>
        <translation>模型没有带名称的参数。</translation>
    </message>
    <message>
        <source>Tries the ranges of the values that others can adjust.</source>
        <translation>试遍别人可以调整的参数的范围。</translation>
    </message>
    <message>
        <source>Another number tries other places, the same one the same.</source>
        <translation>换个数字，试别的位置；数字相同，位置相同。</translation>
    </message>
    <message>
        <source>there are more cells than names.</source>
        <translation>单元格比名称多。</translation>
    </message>
    <message>
        <source>%1:%2: %3</source>
        <extracomment>%1 is a file&apos;s name, %2 the number of a line, %3 a sentence</extracomment>
        <translation>%1:%2: %3</translation>
    </message>
    <message>
        <source>A CSV file: names of values, and a line of numbers for each variant.</source>
        <translation>CSV 文件：参数的名称，以及每个变体一行数字。</translation>
    </message>
    <message>
        <source>The folder to write to; it is made where there is none.</source>
        <translation>要写入的文件夹；没有则创建。</translation>
    </message>
    <message>
        <source>What is written of each (svg).</source>
        <translation>每个变体写出什么（svg）。</translation>
    </message>
    <message>
        <source>--table and -o are both needed.</source>
        <translation>--table 和 -o 都需要。</translation>
    </message>
    <message>
        <source>--format: found &quot;%1&quot;, expected a kind of cutting file.</source>
        <translation>--format：读到“%1”，应为一种切割文件。</translation>
    </message>
    <message>
        <source>%1: found no line of numbers, expected one below the names.</source>
        <translation>%1：没有读到数字行，名称下面应有一行。</translation>
    </message>
    <message>
        <source>%1: a quote is not closed.</source>
        <translation>%1：有个引号没有闭合。</translation>
    </message>
    <message>
        <source>%1: the folder cannot be made.</source>
        <translation>%1：无法创建文件夹。</translation>
    </message>
    <message>
        <source>Puts a weight on a section, in its middle or at X,Y in mm: &quot;Rib 4=350g&quot;, &quot;Rib 4@10,25=0.35kg&quot;. Can be repeated.</source>
        <translation>在插片上放重物，放在中间或 X,Y（mm）处：“Rib 4=350g”、“Rib 4@10,25=0.35kg”。可重复使用。</translation>
    </message>
    <message>
        <source>--weight %1: expected NAME=MASS, as in &quot;Rib 4=350g&quot;.</source>
        <translation>--weight %1：应为 名称=质量，例如“Rib 4=350g”。</translation>
    </message>
    <message>
        <source>--weight %1: expected a mass above 0 and up to 1000000 kg behind the =, with g, kg, oz or lb.</source>
        <translation>--weight %1：= 后面应为大于 0、不超过 1000000 kg 的质量，单位 g、kg、oz 或 lb。</translation>
    </message>
    <message>
        <source>--weight %1: there is no section &quot;%2&quot;.</source>
        <translation>--weight %1：没有插片“%2”。</translation>
    </message>
    <message>
        <source>--weight %1: slits leave nothing of &quot;%2&quot;.</source>
        <translation>--weight %1：插槽把“%2”切得什么都不剩。</translation>
    </message>
    <message>
        <source>%1: two columns are named &quot;%2&quot;.</source>
        <translation>%1：有两列都叫 &quot;%2&quot;。</translation>
    </message>
    <message>
        <source>%1: this kind of file cannot be written; expected .pdf, .html or .png.</source>
        <translation>%1：不能写这种文件；应为 .pdf、.html 或 .png。</translation>
    </message>
    <message>
        <source>--size is for .png; a web page fits its screen.</source>
        <translation>--size 用于 .png；网页会适应屏幕。</translation>
    </message>
    <message>
        <source>A picture of the steps could not be made.</source>
        <translation>无法生成步骤的图片。</translation>
    </message>
    <message>
        <source>A PDF file with all steps (- is standard output), OUT.html for a web page where the model can be turned, also on a phone, or OUT.png for OUT-01.png, OUT-02.png and so on.</source>
        <translation>含全部步骤的 PDF 文件（- 表示标准输出），用 OUT.html 写出可转动模型的网页（手机上也能看），或用 OUT.png 写出 OUT-01.png、OUT-02.png 等。</translation>
    </message>
    <message>
        <source>--offcut: so many offcuts of the stock %1 are too many.</source>
        <translation>--offcut：材料 %1 的余料太多。</translation>
    </message>
    <message>
        <source>Sheets of %1 that are missing: %2</source>
        <extracomment>%1 is a stock, %2 a number</extracomment>
        <translation>缺少的 %1 板材：%2</translation>
    </message>
    <message>
        <source>The steps are not among the files: %1</source>
        <extracomment>%1 is a sentence</extracomment>
        <translation>文件中没有步骤：%1</translation>
    </message>
    <message>
        <source>Sheets of %1 have no room within margins of %2 mm.</source>
        <extracomment>%1 is a stock, %2 a length</extracomment>
        <translation>%1 板材在 %2 mm 边距内没有空间。</translation>
    </message>
    <message>
        <source>--offcut: found &quot;%1&quot;, expected width x height in mm, such as 300x200, or an .svg file, and behind them how many there are, such as :2.</source>
        <translation>--offcut：找到“%1”，应为以 mm 表示的宽 x 高，例如 300x200，或 .svg 文件，后面可加数量，例如 :2。</translation>
    </message>
    <message>
        <source>Size of a sheet, such as 600x400; with :N behind it, how many there are.</source>
        <translation>板材尺寸，例如 600x400；后面加 :N 表示数量。</translation>
    </message>
    <message>
        <source>--offcut %1: the model has no stock &quot;%2&quot;; it is cut from %3.</source>
        <extracomment>%1 is what was typed, %2 the name of a stock, %3 names of stocks</extracomment>
        <translation>--offcut %1：模型没有材料“%2”，它用 %3 切割。</translation>
    </message>
    <message>
        <source>--offcut %1: the model is cut from %2. Say of which this one is, as in &quot;%3=%1&quot;.</source>
        <translation>--offcut %1：模型用 %2 切割。请说明这是哪种材料的余料，例如“%3=%1”。</translation>
    </message>
    <message>
        <source>A sheet of another size, or what is left of one as the largest outline of an .svg file in true size, which is used up before whole ones; with :N behind it, so many of them. Of a model of several stocks with the stock&apos;s name in front: &quot;Birch plywood=300x200&quot;. May be repeated.</source>
        <translation>另一种尺寸的板材，或用剩的板材（实际尺寸的 .svg 文件中最大的轮廓线），先于整张板材用完；后面加 :N 表示数量。模型有多种材料时，在前面加材料名称：“Birch plywood=300x200”。可以重复。</translation>
    </message>
    <message>
        <source>Leaves only walls of this width along the contours, and where others cross.</source>
        <translation>只留下沿轮廓以及与其他插片相交处、这个宽度的壁。</translation>
    </message>
    <message>
        <source>Engraves the numbers of each joint in a colour of its own, the same on both parts.</source>
        <translation>用不同的颜色雕刻每个接头的编号，两个零件上颜色相同。</translation>
    </message>
    <message>
        <source>--joint-colours: this kind of file cannot hold them; expected %1.</source>
        <translation>--joint-colours：这种文件不支持，应为 %1。</translation>
    </message>
    <message>
        <source>Cut once for two parts: %1 mm.</source>
        <extracomment>%1 is a length</extracomment>
        <translation>两个零件只切一次的边：%1 mm。</translation>
    </message>
    <message>
        <source>No edges of two parts lie on each other: nothing is cut once. With --spacing 0 straight edges can.</source>
        <translation>没有两个零件的边贴在一起：没有只切一次的边。使用 --spacing 0 时直边可以贴合。</translation>
    </message>
    <message>
        <source>Slits %1 to %2 have clearances from %3 to %4 mm: push the strip in, and give the stock the clearance of the one that fits.</source>
        <translation>插槽 %1 到 %2 的间隙为 %3 到 %4 mm：把条插进去，再把合适的那个间隙设给材料。</translation>
    </message>
    <message>
        <source>No room for the leads of all cuts: %1</source>
        <translation>放不下所有切割的引线：%1</translation>
    </message>
</context>
<context>
    <name>fff::ui::AboutDialog</name>
    <message>
        <source>About FlatFitFab</source>
        <translation>关于 FlatFitFab</translation>
    </message>
    <message>
        <source>Licences</source>
        <translation>许可证</translation>
    </message>
    <message>
        <source>For bug reports</source>
        <translation>用于报告错误</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>FlatFitFab %1</source>
        <translation>FlatFitFab %1</translation>
    </message>
    <message>
        <source>Draw flat parts in 3D, see at once how they fit, and cut them. It works without an account, and nothing leaves this computer.</source>
        <translation>在 3D 中画平板零件，马上看到它们怎样拼合，然后切割出来。不需要账号，任何内容都不会离开这台电脑。</translation>
    </message>
    <message>
        <source>After “FlatFitFab: Interactive Modeling with Planar Sections” by J. McCrae, N. Umetani and K. Singh (UIST 2014). Free software under the GNU General Public License, version 3 or later.</source>
        <translation>源自 J. McCrae、N. Umetani 和 K. Singh 的“FlatFitFab: Interactive Modeling with Planar Sections”（UIST 2014）。本程序是自由软件，采用 GNU 通用公共许可证第 3 版或更新版本。</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>What this program is built with</source>
        <translation>这个程序用到的软件</translation>
    </message>
    <message>
        <source>Text of the licence</source>
        <translation>许可证全文</translation>
    </message>
    <message>
        <source>This program</source>
        <translation>本程序</translation>
    </message>
    <message>
        <source>Windows, files and text</source>
        <translation>窗口、文件和文字</translation>
    </message>
    <message>
        <source>Exact geometry</source>
        <translation>精确几何</translation>
    </message>
    <message>
        <source>Vectors and matrices</source>
        <translation>向量和矩阵</translation>
    </message>
    <message>
        <source>Cutting and offsetting outlines</source>
        <translation>轮廓线的裁切和偏移</translation>
    </message>
    <message>
        <source>Reading drawings</source>
        <translation>读取图稿</translation>
    </message>
    <message>
        <source>Unpacking drawings</source>
        <translation>解包图稿</translation>
    </message>
    <message>
        <source>Models with pictures and meshes</source>
        <translation>带图片和网格的模型</translation>
    </message>
    <message>
        <source>Parts that CGAL uses</source>
        <translation>CGAL 用到的部分</translation>
    </message>
    <message>
        <source>Numbers without rounding</source>
        <translation>无舍入的数</translation>
    </message>
    <message>
        <source>Numbers with many digits</source>
        <translation>多位数</translation>
    </message>
    <message>
        <source>Results that may be errors</source>
        <translation>可能是错误的结果</translation>
    </message>
    <message>
        <source>The model in web pages of the steps</source>
        <translation>步骤网页中的模型</translation>
    </message>
</context>
<context>
    <name>fff::ui::ActionSet</name>
    <message>
        <source>&amp;File</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>编辑</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>视图</translation>
    </message>
    <message>
        <source>&amp;Section</source>
        <translation>插片</translation>
    </message>
    <message>
        <source>&amp;Operation</source>
        <translation>操作</translation>
    </message>
    <message>
        <source>&amp;Checks</source>
        <translation>检查</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>帮助</translation>
    </message>
    <message>
        <source>&amp;Look from</source>
        <translation>观察方向</translation>
    </message>
    <message>
        <source>Pa&amp;nels</source>
        <translation>面板</translation>
    </message>
    <message>
        <source>Draw on a p&amp;lane</source>
        <translation>在平面上画</translation>
    </message>
    <message>
        <source>Dra&amp;w on it</source>
        <translation>在它上面画</translation>
    </message>
    <message>
        <source>Arran&amp;ge</source>
        <translation>排列</translation>
    </message>
    <message>
        <source>&amp;Select</source>
        <translation>选择</translation>
    </message>
</context>
<context>
    <name>fff::ui::AdjustBar</name>
    <message>
        <source>Tool bar for adjusting</source>
        <translation>调整工具栏</translation>
    </message>
</context>
<context>
    <name>fff::ui::AgoText</name>
    <message>
        <source>just now</source>
        <translation>刚刚</translation>
    </message>
    <message numerus="yes">
        <source>%n minute(s) ago</source>
        <translation>
            <numerusform>%n 分钟前</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n hour(s) ago</source>
        <translation>
            <numerusform>%n 小时前</numerusform>
        </translation>
    </message>
    <message>
        <source>yesterday</source>
        <translation>昨天</translation>
    </message>
    <message numerus="yes">
        <source>%n day(s) ago</source>
        <translation>
            <numerusform>%n 天前</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::Badge</name>
    <message>
        <source>Older than the drawing</source>
        <translation>结果已过时</translation>
    </message>
    <message>
        <source>%1: older than the drawing</source>
        <translation>%1：结果已过时</translation>
    </message>
</context>
<context>
    <name>fff::ui::Badges</name>
    <message>
        <source>Verdicts</source>
        <translation>结论</translation>
    </message>
</context>
<context>
    <name>fff::ui::BearingMarks</name>
    <message>
        <source>Holds</source>
        <translation>能承受</translation>
    </message>
    <message>
        <source>Without bending</source>
        <translation>不计弯曲</translation>
    </message>
</context>
<context>
    <name>fff::ui::BearingPicture</name>
    <message>
        <source>The section is not there</source>
        <translation>这个插片不在</translation>
    </message>
    <message>
        <source>It does not stand as it is</source>
        <translation>它现在站不稳</translation>
    </message>
    <message>
        <source>It breaks as it is</source>
        <translation>它现在会断裂</translation>
    </message>
    <message>
        <source>Strength unknown</source>
        <translation>强度未知</translation>
    </message>
    <message>
        <source>working… %1&#x202f;%</source>
        <translation>计算中… %1&#x202f;%</translation>
    </message>
    <message>
        <source>working…</source>
        <translation>计算中…</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>已停止</translation>
    </message>
    <message>
        <source>could not be worked out</source>
        <translation>无法算出</translation>
    </message>
</context>
<context>
    <name>fff::ui::CanvasBar</name>
    <message>
        <source>Numbers of the drawing tool</source>
        <translation>绘图工具的数字</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>距离</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>右</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>上</translation>
    </message>
    <message>
        <source>Out</source>
        <extracomment>away from its plane</extracomment>
        <translation>外</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>转动</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大小</translation>
    </message>
    <message>
        <source>Copies</source>
        <translation>副本</translation>
    </message>
</context>
<context>
    <name>fff::ui::CheckRow</name>
    <message>
        <source>Older than the drawing</source>
        <translation>结果已过时</translation>
    </message>
</context>
<context>
    <name>fff::ui::CheckWords</name>
    <message>
        <source>%1: %2</source>
        <extracomment>%1 names sections, %2 is a sentence about them such as &quot;Tips only past 12°.&quot;</extracomment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Good</source>
        <translation>良好</translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>说明</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>问题</translation>
    </message>
</context>
<context>
    <name>fff::ui::ChecksDock</name>
    <message numerus="yes">
        <source>%1 in %n places</source>
        <extracomment>%1 is what is wrong, such as &quot;Sections overlap&quot;</extracomment>
        <translation>
            <numerusform>%1，共 %n 处</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2: %3</source>
        <extracomment>%1 of %2 places, and the sentence about that one</extracomment>
        <translation>%1/%2：%3</translation>
    </message>
    <message>
        <source>Checks</source>
        <translation>检查</translation>
    </message>
    <message>
        <source>Checks begin with the first section.</source>
        <translation>画出第一个插片后开始检查。</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation>正在检查…</translation>
    </message>
    <message>
        <source>Older than the drawing</source>
        <translation>结果已过时</translation>
    </message>
    <message>
        <source>There is no section to check yet.</source>
        <translation>还没有插片可检查。</translation>
    </message>
    <message>
        <source>No problems.</source>
        <translation>没有问题。</translation>
    </message>
    <message>
        <source>Still checking; no problems so far.</source>
        <translation>还在检查；目前没有问题。</translation>
    </message>
    <message>
        <source>Problem %1 of %2: %3.</source>
        <translation>问题 %1，共 %2 个：%3。</translation>
    </message>
    <message>
        <source>Still checking. This will be done as soon as the result is known.</source>
        <translation>还在检查。结果一出来就会执行。</translation>
    </message>
    <message>
        <source>The model has changed; this can no longer be done.</source>
        <translation>模型已改动；不能再这样做。</translation>
    </message>
    <message>
        <source>Done: %1.</source>
        <extracomment>%1 is what a link did, as it was said before: &quot;6 joints flipped, 1 problem solved&quot;</extracomment>
        <translation>已完成：%1。</translation>
    </message>
    <message>
        <source>If you click: %1.</source>
        <extracomment>%1 is what a link would do, such as &quot;6 joints flipped, 1 problem solved&quot;</extracomment>
        <translation>点击后：%1。</translation>
    </message>
    <message>
        <source>Problem %1 of %2, place %3 of %4: %5.</source>
        <translation>问题 %1，共 %2 个；位置 %3，共 %4 处：%5。</translation>
    </message>
</context>
<context>
    <name>fff::ui::ChosenPlace</name>
    <message>
        <source>Export to</source>
        <translation>导出到</translation>
    </message>
</context>
<context>
    <name>fff::ui::CommandSearch</name>
    <message>
        <source>Find a command</source>
        <translation>查找命令</translation>
    </message>
    <message>
        <source>Type what you want to do</source>
        <translation>输入你想做的事</translation>
    </message>
    <message>
        <source>Matching commands</source>
        <translation>匹配的命令</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>why</comment>
        <extracomment>where an action is in the menus, and why it cannot be done now</extracomment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>No matching commands</source>
        <translation>没有匹配的命令</translation>
    </message>
    <message>
        <source>Try another word</source>
        <translation>换个词试试</translation>
    </message>
</context>
<context>
    <name>fff::ui::CouponExport</name>
    <message>
        <source>Write a fit coupon</source>
        <translation>写出试片</translation>
    </message>
    <message>
        <source>%1 coupon</source>
        <extracomment>%1 is a model&apos;s name: what the file of its test piece is called</extracomment>
        <translation>%1 试片</translation>
    </message>
    <message>
        <source>Wrote a fit coupon to %1. Cut it and push the strip into its slits; Export asks which one fitted.</source>
        <extracomment>%1 is the name of a file</extracomment>
        <translation>试片已写到 %1。把它切割出来，把条插进插槽；导出时会问哪个合适。</translation>
    </message>
</context>
<context>
    <name>fff::ui::CutRows</name>
    <message>
        <source>%1: no clearance</source>
        <extracomment>%1 is the number of a slit</extracomment>
        <translation>%1：无间隙</translation>
    </message>
    <message>
        <source>%1: %2 narrower</source>
        <extracomment>%1 is the number of a slit, %2 a length</extracomment>
        <translation>%1：窄 %2</translation>
    </message>
    <message>
        <source>%1: %2 wider</source>
        <translation>%1：宽 %2</translation>
    </message>
    <message>
        <source>Bridges</source>
        <translation>微连</translation>
    </message>
    <message>
        <source>So many short gaps in each part&apos;s cut hold it in its sheet; 0: none</source>
        <translation>每个零件的切线上留这么多小缺口，把它留在板材上；0：不留</translation>
    </message>
    <message>
        <source>Width of bridges</source>
        <translation>微连宽度</translation>
    </message>
    <message>
        <source>Lead-in</source>
        <translation>引入线</translation>
    </message>
    <message>
        <source>Each cut begins and ends so far beside its line, in the waste; 0: on the line</source>
        <translation>每次切割都在切线旁这么远的废料中开始和结束；0：就在切线上</translation>
    </message>
    <message>
        <source>cut once</source>
        <translation>只切一次</translation>
    </message>
    <message>
        <source>Shared edges</source>
        <translation>共用边</translation>
    </message>
    <message>
        <source>Of parts that lie against each other, where the spacing is 0</source>
        <translation>指间距为 0 时贴在一起的零件</translation>
    </message>
    <message>
        <source>Which of the numbered slits of a fit coupon holds the sheet best (cut one: menu File, or among the files for the workshop). It sets the clearance.</source>
        <translation>试片上编号的插槽中哪一个最能卡住板材（试片可从“文件”菜单或加工全套文件中切割）。用来设定间隙。</translation>
    </message>
    <message>
        <source>Slit that fitted</source>
        <translation>合适的插槽</translation>
    </message>
</context>
<context>
    <name>fff::ui::CutTime</name>
    <message numerus="yes">
        <source>about %n min</source>
        <extracomment>how long a machine cuts</extracomment>
        <translation>
            <numerusform>约 %n 分钟</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::DimensionGroup</name>
    <message>
        <source>Dimensions</source>
        <translation>尺寸</translation>
    </message>
    <message>
        <source>Dimension %1</source>
        <extracomment>%1 is a number</extracomment>
        <translation>尺寸 %1</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <extracomment>%1 is the name of a section, %2 a number</extracomment>
        <translation>%1（%2）</translation>
    </message>
    <message>
        <source>Changing this length scales the whole model</source>
        <translation>更改这个长度会缩放整个模型</translation>
    </message>
    <message>
        <source>Changing this length stretches %1 between the two places</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>更改这个长度会在两处之间拉伸 %1</translation>
    </message>
    <message>
        <source>Delete this dimension</source>
        <translation>删除这个尺寸</translation>
    </message>
</context>
<context>
    <name>fff::ui::DocumentFiles</name>
    <message>
        <source>Open a model</source>
        <translation>打开模型</translation>
    </message>
    <message>
        <source>Insert a model</source>
        <translation>插入模型</translation>
    </message>
    <message>
        <source>Import a drawing</source>
        <translation>导入图稿</translation>
    </message>
    <message>
        <source>Add a template</source>
        <translation>添加参考物</translation>
    </message>
    <message>
        <source>Nothing inserted: %1 has no sections.</source>
        <translation>没有插入：%1 没有插片。</translation>
    </message>
    <message>
        <source>Save the model</source>
        <translation>保存模型</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>未保存的改动</translation>
    </message>
    <message>
        <source>Save the changes to %1?</source>
        <translation>要保存对 %1 的改动吗？</translation>
    </message>
    <message>
        <source>Without saving, they are lost.</source>
        <translation>不保存的话，这些改动会丢失。</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Don’t save</source>
        <translation>不保存</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Revert to saved</source>
        <translation>恢复到已保存版本</translation>
    </message>
    <message>
        <source>%1 is as it was saved. Undo brings your changes back.</source>
        <translation>%1 已恢复到保存时的样子。撤销可找回你的改动。</translation>
    </message>
    <message>
        <source>Opening %1…</source>
        <translation>正在打开 %1…</translation>
    </message>
    <message>
        <source>Choose another file</source>
        <translation>选择另一个文件</translation>
    </message>
    <message>
        <source>Remove from the list</source>
        <translation>从列表中移除</translation>
    </message>
    <message>
        <source>Saving %1…</source>
        <translation>正在保存 %1…</translation>
    </message>
    <message>
        <source>Save somewhere else…</source>
        <translation>保存到别处…</translation>
    </message>
    <message>
        <source>Saved to %1.</source>
        <translation>已保存到 %1。</translation>
    </message>
    <message>
        <source>Changed on disk</source>
        <translation>磁盘上的文件已改动</translation>
    </message>
    <message>
        <source>%1 was changed by another program.</source>
        <translation>%1 被另一个程序改动过。</translation>
    </message>
    <message>
        <source>Overwriting it would lose those changes.</source>
        <translation>覆盖它会丢失那些改动。</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>另存为…</translation>
    </message>
    <message>
        <source>Overwrite</source>
        <translation>覆盖</translation>
    </message>
    <message>
        <source>untitled</source>
        <translation>未命名</translation>
    </message>
</context>
<context>
    <name>fff::ui::DrawingGroup</name>
    <message>
        <source>Drawing</source>
        <translation>绘图</translation>
    </message>
    <message>
        <source>Local symmetry</source>
        <translation>局部对称</translation>
    </message>
    <message>
        <source>Mirror a contour across its slit when it is drawn on one side of it. Shift does the opposite while you draw.</source>
        <translation>轮廓只画在插槽一侧时，把它镜像到另一侧。绘图时按住 Shift 则相反。</translation>
    </message>
    <message>
        <source>Mirror the first</source>
        <translation>镜像第一个</translation>
    </message>
    <message>
        <source>Mirror the first section too, across the vertical through its start</source>
        <translation>第一个插片也镜像，以过其起点的竖直线为轴</translation>
    </message>
    <message>
        <source>Cut at ground</source>
        <translation>在地面切平</translation>
    </message>
    <message>
        <source>Cut flat at the ground: leave out what is drawn below it</source>
        <translation>在地面处切平：略去画在地面以下的部分</translation>
    </message>
    <message>
        <source>Snap</source>
        <translation>吸附</translation>
    </message>
    <message>
        <source>Snap to points, alignment lines, ground and grid</source>
        <translation>吸附到点、对齐线、地面和方格</translation>
    </message>
    <message>
        <source>View turns by</source>
        <translation>视图转角</translation>
    </message>
    <message>
        <source>At 90° you look straight at the new plane; with less, the section that you started on stays visible</source>
        <translation>90° 时正对新平面；小一些则还能看到起笔的那个插片</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Turning time</source>
        <translation>转动时间</translation>
    </message>
    <message>
        <source>How long the view takes to turn to the plane of a new section</source>
        <translation>视图转到新插片的平面要用多久</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
</context>
<context>
    <name>fff::ui::DrawingPage</name>
    <message>
        <source>A hole, while you draw it</source>
        <translation>孔，绘图中</translation>
    </message>
    <message>
        <source>A new contour, while you draw it</source>
        <translation>新轮廓，绘图中</translation>
    </message>
    <message>
        <source>New section, while you draw it</source>
        <translation>新插片，绘图中</translation>
    </message>
    <message>
        <source>Its contour comes next</source>
        <translation>接下来画它的轮廓</translation>
    </message>
    <message>
        <source>Stock</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>厚度</translation>
    </message>
    <message>
        <source>Slit</source>
        <translation>插槽</translation>
    </message>
    <message>
        <source>On</source>
        <translation>所在插片</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>Its own slit</source>
        <translation>自己的插槽</translation>
    </message>
    <message>
        <source>Contour</source>
        <translation>轮廓</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大小</translation>
    </message>
    <message>
        <source>Curve pieces</source>
        <translation>曲线段</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>质量</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>tabs</source>
        <translation>榫头</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>封闭</translation>
    </message>
    <message>
        <source>opens up, %1 deep</source>
        <translation>朝上开口，深 %1</translation>
    </message>
    <message>
        <source>opens down, %1 deep</source>
        <translation>朝下开口，深 %1</translation>
    </message>
    <message>
        <source>opens sideways, %1 deep</source>
        <translation>朝侧面开口，深 %1</translation>
    </message>
    <message>
        <source>&lt;b&gt;Not mirrored.&lt;/b&gt; The two halves would not meet at the slit.</source>
        <translation>&lt;b&gt;没有镜像。&lt;/b&gt;两半在插槽处接不上。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Not mirrored.&lt;/b&gt; You drew on one side of the axis: %1 on one side, %2 on the other. Symmetry is off, or Shift is held.</source>
        <translation>&lt;b&gt;没有镜像。&lt;/b&gt;你画在了轴的一侧：一侧 %1，另一侧 %2。对称已关闭，或按住了 Shift。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Mirrored.&lt;/b&gt; You drew on one side of the axis: %1 on one side, %2 on the other. Cross it by %3 or more to draw both sides yourself.</source>
        <translation>&lt;b&gt;已镜像。&lt;/b&gt;你画在了轴的一侧：一侧 %1，另一侧 %2。越过轴 %3 以上，就由你自己画两侧。</translation>
    </message>
    <message>
        <source>New section</source>
        <translation>新插片</translation>
    </message>
    <message>
        <source>Template</source>
        <translation>参考物</translation>
    </message>
    <message>
        <source>Follows</source>
        <translation>沿着</translation>
    </message>
    <message>
        <source>On the guide</source>
        <translation>在引导线上</translation>
    </message>
    <message>
        <source>%1 % of the stroke</source>
        <extracomment>%1 is a number: of the line that somebody draws</extracomment>
        <translation>一笔的 %1 %</translation>
    </message>
    <message>
        <source>Farthest off</source>
        <translation>最大偏离</translation>
    </message>
</context>
<context>
    <name>fff::ui::DrivenField</name>
    <message>
        <source>Only one number at a time can follow a value.</source>
        <translation>一次只能有一个数字跟随参数。</translation>
    </message>
    <message>
        <source>This number cannot follow a value.</source>
        <translation>这个数字不能跟随参数。</translation>
    </message>
</context>
<context>
    <name>fff::ui::ExceptionRows</name>
    <message>
        <source>None. Click one section to leave it out or to detach it.</source>
        <translation>没有。点击一个插片可略去或分离它。</translation>
    </message>
    <message>
        <source>Show again</source>
        <translation>重新显示</translation>
    </message>
    <message>
        <source>No. %1</source>
        <translation>第 %1 个</translation>
    </message>
    <message>
        <source>%1, left out</source>
        <translation>%1，已略去</translation>
    </message>
    <message>
        <source>%1, detached</source>
        <translation>%1，已分离</translation>
    </message>
</context>
<context>
    <name>fff::ui::ExportDialog</name>
    <message>
        <source>Export cutting files</source>
        <translation>导出切割文件</translation>
    </message>
    <message>
        <source>Open the folder afterwards</source>
        <translation>完成后打开文件夹</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Skin over %1</source>
        <extracomment>%1 are the sections of the model</extracomment>
        <translation>覆盖 %1的蒙皮</translation>
    </message>
    <message>
        <source>%1 as solids</source>
        <extracomment>%1 are the sections of the model</extracomment>
        <translation>%1，实体</translation>
    </message>
    <message>
        <source>%1 on %2 · %3 of cutting</source>
        <extracomment>%1 are the parts, %2 the sheets, %3 is how far the machine cuts</extracomment>
        <translation>%1，%2 · 切割 %3</translation>
    </message>
    <message>
        <source>Working…</source>
        <translation>计算中…</translation>
    </message>
    <message>
        <source>Export anyway</source>
        <translation>仍然导出</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>导出</translation>
    </message>
    <message>
        <source>Nesting…</source>
        <translation>正在排版…</translation>
    </message>
</context>
<context>
    <name>fff::ui::ExportPlaceRow</name>
    <message>
        <source>Change…</source>
        <translation>更改…</translation>
    </message>
    <message>
        <source>%1 and so on, in %2</source>
        <translation>%1 等文件，在 %2 中</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <extracomment>%1 is a file&apos;s name, or several, %2 their folder&apos;s</extracomment>
        <translation>%1，在 %2 中</translation>
    </message>
    <message>
        <source>Replaces %1 in %2</source>
        <extracomment>%1 is the name of a file that is there, %2 its folder&apos;s</extracomment>
        <translation>替换 %2 中的 %1</translation>
    </message>
    <message>
        <source>your home folder</source>
        <translation>主文件夹</translation>
    </message>
</context>
<context>
    <name>fff::ui::ExportPreview</name>
    <message>
        <source>Sheet %1 of %2</source>
        <translation>板材 %1/%2</translation>
    </message>
    <message>
        <source>Parts list</source>
        <translation>零件清单</translation>
    </message>
    <message>
        <source>Previous sheet (Page Up)</source>
        <translation>上一张板材（Page Up）</translation>
    </message>
    <message>
        <source>Next sheet (Page Down)</source>
        <translation>下一张板材（Page Down）</translation>
    </message>
    <message>
        <source>Show the whole sheet</source>
        <translation>显示整张板材</translation>
    </message>
    <message>
        <source>A skin has no sheets: the file holds the form that the sections suggest, as a surface over their contours.</source>
        <translation>蒙皮不用板材：文件包含插片勾勒出的形体，是覆盖在轮廓上的曲面。</translation>
    </message>
    <message>
        <source>Solids have no sheets: the file holds the model as it stands, true to size, with its slits.</source>
        <translation>实体不用板材：文件包含模型立着的样子，实际尺寸，带插槽。</translation>
    </message>
    <message>
        <source>Sheet %1 · %2 · %3</source>
        <extracomment>%1 is the number of a sheet, %2 the name of a stock, %3 the sheet&apos;s size</extracomment>
        <translation>板材 %1 · %2 · %3</translation>
    </message>
    <message>
        <source>There is nothing to cut.</source>
        <translation>没有可切割的。</translation>
    </message>
    <message>
        <source>Working…</source>
        <translation>计算中…</translation>
    </message>
    <message>
        <source>Used: %1</source>
        <extracomment>%1 is a number with a percent sign</extracomment>
        <translation>利用率：%1</translation>
    </message>
    <message>
        <source>Laying the parts on sheets…</source>
        <translation>正在把零件排到板材上…</translation>
    </message>
</context>
<context>
    <name>fff::ui::ExportQuestions</name>
    <message>
        <source>Which stock?</source>
        <translation>哪种材料？</translation>
    </message>
    <message>
        <source>Measure again</source>
        <translation>重新测量</translation>
    </message>
    <message>
        <source>Measured thickness</source>
        <translation>测得厚度</translation>
    </message>
    <message>
        <source>Measure the sheet that you will cut with calipers: slits are drawn to fit it.</source>
        <translation>用卡尺量一下要切割的板材：插槽会按它来画。</translation>
    </message>
    <message>
        <source>Which sheet?</source>
        <translation>哪种板材？</translation>
    </message>
    <message>
        <source>Width of the sheet</source>
        <translation>板材宽度</translation>
    </message>
    <message>
        <source>Height of the sheet</source>
        <translation>板材高度</translation>
    </message>
    <message>
        <source>%1, %2 thick</source>
        <extracomment>%1 is the name of a stock, %2 its thickness</extracomment>
        <translation>%1，厚 %2</translation>
    </message>
    <message>
        <source>Own size</source>
        <translation>自定尺寸</translation>
    </message>
    <message>
        <source>Which machine?</source>
        <translation>哪台机器？</translation>
    </message>
    <message>
        <source>Colours, layers, speeds and G-code as this machine and its program take them, and what it removes of each stock</source>
        <translation>这台机器及其程序使用的颜色、图层、速度和 G 代码，以及它从每种材料上切去的宽度</translation>
    </message>
    <message>
        <source>%1, measured %2</source>
        <translation>%1，实测 %2</translation>
    </message>
    <message>
        <source>That is what I measured</source>
        <translation>这是我测量的值</translation>
    </message>
    <message numerus="yes">
        <source>%n offcut(s) are used up first.</source>
        <translation>
            <numerusform>先使用 %n 块余料。</numerusform>
        </translation>
    </message>
    <message>
        <source>Any laser</source>
        <translation>任意激光机</translation>
    </message>
    <message>
        <source>No part lies on an offcut.</source>
        <translation>没有零件放在余料上。</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n offcut(s) used up first.</source>
        <extracomment>%1 is a number</extracomment>
        <translation>
            <numerusform>先使用 %n 块余料中的 %1 块。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::ExportRemarks</name>
    <message>
        <source>%1, %2 times</source>
        <extracomment>%1 is a verdict, %2 how often it is so, two at least</extracomment>
        <translation>%1，%2 次</translation>
    </message>
    <message>
        <source>Cannot be cut</source>
        <translation>无法切割</translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation>正在检查…</translation>
    </message>
    <message>
        <source>Nothing to look out for.</source>
        <translation>没有要注意的。</translation>
    </message>
    <message>
        <source>A sheet of %1 has no room within margins of %2.</source>
        <extracomment>%1 is a stock, %2 a length</extracomment>
        <translation>%1 板材在 %2 边距内没有空间。</translation>
    </message>
    <message>
        <source>The kerf width of %1 is 0: slits become wider, and parts smaller, by what the machine removes.</source>
        <extracomment>%1 is a stock</extracomment>
        <translation>%1 的切缝为 0：机器切掉多少，插槽就宽多少，零件就小多少。</translation>
    </message>
    <message>
        <source>Sheets are larger than the bed of %1, which is %2. Choose smaller ones.</source>
        <extracomment>%1 is a machine, %2 the size of its bed</extracomment>
        <translation>板材超出 %1 的工作台面 %2。请选择更小的板材。</translation>
    </message>
</context>
<context>
    <name>fff::ui::ExportRows</name>
    <message>
        <source>Fit</source>
        <translation>配合</translation>
    </message>
    <message>
        <source>Kerf width (full)</source>
        <translation>切缝宽度（全宽）</translation>
    </message>
    <message>
        <source>Slit clearance</source>
        <translation>插槽间隙</translation>
    </message>
    <message>
        <source>Drawn slit width</source>
        <translation>所画插槽宽</translation>
    </message>
    <message>
        <source>Layout</source>
        <translation>排版</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>间距</translation>
    </message>
    <message>
        <source>Margin at the edge</source>
        <translation>板材边距</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>旋转</translation>
    </message>
    <message>
        <source>Quarter turns for a sheet with a grain</source>
        <translation>有纹理的板材请用四分之一圈</translation>
    </message>
    <message>
        <source>100 mm, below the sheets</source>
        <translation>100 mm，在板材下方</translation>
    </message>
    <message>
        <source>Measuring bar</source>
        <translation>标尺</translation>
    </message>
    <message>
        <source>Drawn beside the sheets, not cut: measure it on your machine to check the size</source>
        <translation>画在板材旁边，不切割：在机器上量一量，核对尺寸</translation>
    </message>
    <message>
        <source>Cuts</source>
        <translation>切割</translation>
    </message>
    <message>
        <source>Any angle</source>
        <translation>任意角度</translation>
    </message>
    <message>
        <source>Quarter turns</source>
        <translation>四分之一圈</translation>
    </message>
    <message>
        <source>Half turns</source>
        <translation>半圈</translation>
    </message>
    <message>
        <source>As drawn</source>
        <translation>按所画</translation>
    </message>
    <message>
        <source>Kept for this stock and the machine that is chosen</source>
        <translation>为此材料和所选机器保存</translation>
    </message>
    <message>
        <source>a colour for each joint</source>
        <translation>每个接头一种颜色</translation>
    </message>
    <message>
        <source>Joint numbers</source>
        <translation>接头编号</translation>
    </message>
    <message>
        <source>The two parts of a joint have its number in the same colour: for paper, and for machines that are told what to do with each colour</source>
        <translation>接头的两个零件用同一种颜色写编号：用于纸张，也用于按颜色设定操作的机器</translation>
    </message>
    <message>
        <source>Not sure? Cut a fit coupon first…</source>
        <translation>拿不准？先切一块试片…</translation>
    </message>
</context>
<context>
    <name>fff::ui::Exporting</name>
    <message>
        <source>The slits of %1 leave nothing of it. It is not cut.</source>
        <translation>插槽把 %1 切得什么都不剩。它不会切割。</translation>
    </message>
    <message>
        <source>%1 is larger than the sheet. It lies on a sheet of its own size.</source>
        <translation>%1 比板材大。它单独放在与它一样大的板材上。</translation>
    </message>
    <message>
        <source>%1 is too slim to carry its number.</source>
        <translation>%1 太窄，写不下编号。</translation>
    </message>
    <message>
        <source>%1 has a hole or a notch that is narrower than the kerf and is not cut.</source>
        <translation>%1 有个孔或缺口比切缝还窄，不会切割。</translation>
    </message>
    <message>
        <source>%1 has no room for the numbers of all its joints.</source>
        <translation>%1 写不下它所有接头的编号。</translation>
    </message>
    <message numerus="yes">
        <source>%n part(s)</source>
        <translation>
            <numerusform>%n 个零件</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sheet(s)</source>
        <translation>
            <numerusform>%n 张板材</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n 个插片</numerusform>
        </translation>
    </message>
    <message>
        <source>Exporting %1…</source>
        <translation>正在导出 %1…</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 到 %2</translation>
    </message>
    <message>
        <source>Exported %1 on %2 to %3.</source>
        <translation>已将 %1（%2）导出到 %3。</translation>
    </message>
    <message>
        <source>Exported %1 on %2 to %3; slits are drawn %4 wide.</source>
        <translation>已将 %1（%2）导出到 %3；插槽画成 %4 宽。</translation>
    </message>
    <message>
        <source>Exported %1 on %2 to %3; slits are drawn %4 wide (%5 − %6 kerf).</source>
        <translation>已将 %1（%2）导出到 %3；插槽画成 %4 宽（%5 − 切缝 %6）。</translation>
    </message>
    <message>
        <source>Exported %1 as solids to %2.</source>
        <translation>已将 %1作为实体导出到 %2。</translation>
    </message>
    <message numerus="yes">
        <source>Exported the skin to %1; %n places stay open.</source>
        <translation>
            <numerusform>蒙皮已导出到 %1；有 %n 处保持开口。</numerusform>
        </translation>
    </message>
    <message>
        <source>Exported the skin to %1.</source>
        <translation>蒙皮已导出到 %1。</translation>
    </message>
    <message>
        <source>Stocks…</source>
        <translation>材料…</translation>
    </message>
    <message>
        <source>Export somewhere else…</source>
        <translation>导出到别处…</translation>
    </message>
    <message>
        <source>Sheets of an earlier export are still there: %1.</source>
        <translation>上次导出的板材文件还在：%1。</translation>
    </message>
    <message>
        <source>Not exported: the files that are there stay.</source>
        <translation>没有导出：原有的文件保持不变。</translation>
    </message>
    <message numerus="yes">
        <source>It takes %n more sheet(s) of %1 than there are.</source>
        <extracomment>%1 is the name of a stock</extracomment>
        <translation>
            <numerusform>还缺 %n 张 %1 板材。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::ExpressionText</name>
    <message>
        <source>A number is missing.</source>
        <translation>缺少数字。</translation>
    </message>
    <message>
        <source>“%1” cannot be read here.</source>
        <translation>“%1”在这里无法识别。</translation>
    </message>
    <message>
        <source>Something is missing after “%1”.</source>
        <translation>“%1”后面缺了内容。</translation>
    </message>
    <message>
        <source>A parenthesis is not closed.</source>
        <translation>有个括号没有闭合。</translation>
    </message>
    <message>
        <source>There is one closing parenthesis too many.</source>
        <translation>多了一个右括号。</translation>
    </message>
    <message>
        <source>Nothing can be divided by 0.</source>
        <translation>不能除以 0。</translation>
    </message>
    <message>
        <source>There is no value named “%1”.</source>
        <translation>没有名为“%1”的参数。</translation>
    </message>
    <message>
        <source>This is not a length; multiply a length by a plain number.</source>
        <translation>这不是长度；请用长度乘以普通数字。</translation>
    </message>
    <message>
        <source>This is not a mass; multiply a mass by a plain number.</source>
        <translation>这不是质量；请用质量乘以普通数字。</translation>
    </message>
    <message>
        <source>“t” is the thickness of the stock; there is no single stock here.</source>
        <translation>“t”是材料的厚度；这里不止一种材料。</translation>
    </message>
</context>
<context>
    <name>fff::ui::Failures</name>
    <message>
        <source>line %1</source>
        <translation>第 %1 行</translation>
    </message>
    <message>
        <source>%2’s %1</source>
        <extracomment>%1 is the end of a name, such as &quot;.txt&quot;, %2 a program</extracomment>
        <translation>%2 的 %1</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 和 %2</translation>
    </message>
    <message>
        <source>Nothing was opened: no file was named.</source>
        <translation>没有打开：没有指定文件。</translation>
    </message>
    <message>
        <source>%1 is not a model. FlatFitFab opens %2.</source>
        <translation>%1 不是模型。FlatFitFab 可打开 %2。</translation>
    </message>
    <message>
        <source>%1 could not be opened: it is not in %2 any more. Nothing was changed.</source>
        <translation>无法打开 %1：它已不在 %2 中。没有任何改动。</translation>
    </message>
    <message>
        <source>%1 could not be opened: %2. Nothing was changed.</source>
        <translation>无法打开 %1：%2。没有任何改动。</translation>
    </message>
    <message>
        <source>%1 could not be opened: %2 (%3). Nothing was changed.</source>
        <extracomment>%3 is a place in the file, such as &quot;line 340&quot;</extracomment>
        <translation>无法打开 %1：%2（%3）。没有任何改动。</translation>
    </message>
    <message>
        <source>The file on disk is still the old one.</source>
        <translation>磁盘上仍是旧文件。</translation>
    </message>
    <message>
        <source>Nothing was written.</source>
        <translation>没有写入任何内容。</translation>
    </message>
    <message>
        <source>the folder %1 does not exist</source>
        <translation>文件夹 %1 不存在</translation>
    </message>
    <message>
        <source>Not exported: %1. %2</source>
        <extracomment>%1 the reason, %2 a sentence</extracomment>
        <translation>没有导出：%1。%2</translation>
    </message>
    <message>
        <source>Could not save %1: %2. %3</source>
        <extracomment>%1 a file&apos;s name, %2 the reason, %3 a sentence</extracomment>
        <translation>无法保存 %1：%2。%3</translation>
    </message>
</context>
<context>
    <name>fff::ui::FigureGroup</name>
    <message>
        <source>Shape</source>
        <translation>形状</translation>
    </message>
    <message>
        <source>Contour</source>
        <translation>轮廓</translation>
    </message>
    <message>
        <source>Moving one of its points makes it so</source>
        <translation>移动它的一个点，它就成为手画</translation>
    </message>
    <message>
        <source>Its centre, in the coordinates of the section</source>
        <translation>它的中心，用插片的坐标表示</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Turned by</source>
        <translation>转动</translation>
    </message>
    <message>
        <source>Hole %1</source>
        <extracomment>%1 is a number</extracomment>
        <translation>孔 %1</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Free form</source>
        <translation>自由形状</translation>
    </message>
</context>
<context>
    <name>fff::ui::FileQuestion</name>
    <message>
        <source>Cutting file</source>
        <translation>切割文件</translation>
    </message>
    <message>
        <source>Paper or picture</source>
        <translation>纸张或图片</translation>
    </message>
    <message>
        <source>Solids to print or render</source>
        <translation>用于打印或渲染的实体</translation>
    </message>
    <message>
        <source>List of parts</source>
        <translation>零件清单</translation>
    </message>
    <message>
        <source>Everything for a workshop</source>
        <translation>加工所需的全部文件</translation>
    </message>
    <message>
        <source>Which file?</source>
        <translation>哪种文件？</translation>
    </message>
    <message>
        <source>What is it for?</source>
        <translation>有什么用途？</translation>
    </message>
    <message>
        <source>A file for each sheet</source>
        <translation>每张板材一个文件</translation>
    </message>
</context>
<context>
    <name>fff::ui::FlatGroup</name>
    <message>
        <source>Trace</source>
        <translation>描摹</translation>
    </message>
    <message>
        <source>Lies on</source>
        <translation>放置在</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>地面</translation>
    </message>
    <message>
        <source>Lay it on the ground</source>
        <translation>平放到地面上</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>前面</translation>
    </message>
    <message>
        <source>Stand it up, to be seen from the front</source>
        <translation>竖起来，从前面看</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>侧面</translation>
    </message>
    <message>
        <source>Stand it up, to be seen from the right</source>
        <translation>竖起来，从右面看</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>插片</translation>
    </message>
    <message>
        <source>Lay it on the selected section, with which it goes</source>
        <translation>放到选中的插片上，并跟着它移动</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>转动</translation>
    </message>
    <message>
        <source>Flip</source>
        <translation>翻面</translation>
    </message>
    <message>
        <source>As seen from behind</source>
        <translation>像从背面看到的那样</translation>
    </message>
    <message>
        <source>Align two</source>
        <translation>对齐两张</translation>
    </message>
    <message>
        <source>The last two pictures as front and side of the same thing: as high as each other, and above the same place</source>
        <translation>最后两张图片当作同一物体的正面和侧面：一样高，并在同一位置上方</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>阈值</translation>
    </message>
    <message>
        <source>How dark it has to be to be traced</source>
        <translation>多暗才会被描摹</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>平滑</translation>
    </message>
    <message>
        <source>How round corners become</source>
        <translation>角变得多圆</translation>
    </message>
    <message>
        <source>Outlines</source>
        <translation>轮廓线</translation>
    </message>
    <message>
        <source>Make sections</source>
        <translation>生成插片</translation>
    </message>
    <message>
        <source>Sections of its outlines, on its own plane</source>
        <translation>用它的轮廓线在它自己的平面上生成插片</translation>
    </message>
    <message>
        <source>Cut holes</source>
        <translation>开孔</translation>
    </message>
    <message>
        <source>Holes in the section that it lies on, or that is selected</source>
        <translation>在它所在的或选中的插片上开孔</translation>
    </message>
    <message>
        <source>Engrave</source>
        <translation>雕刻</translation>
    </message>
    <message>
        <source>Lines on the section that it lies on, or that is selected</source>
        <translation>在它所在的或选中的插片上画线</translation>
    </message>
    <message>
        <source>%1: too many for sections</source>
        <extracomment>%1 is a number of outlines</extracomment>
        <translation>%1：太多，无法生成插片</translation>
    </message>
</context>
<context>
    <name>fff::ui::ForceMarks</name>
    <message>
        <source>pulled open, %1&#x202f;N</source>
        <extracomment>%1 is a force in newtons</extracomment>
        <translation>被拉开，%1&#x202f;N</translation>
    </message>
    <message numerus="yes">
        <source>%n joints pulled open, up to %1&#x202f;N</source>
        <extracomment>%1 is a force in newtons</extracomment>
        <translation>
            <numerusform>%n 个接头被拉开，最大 %1&#x202f;N</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::FormatFilters</name>
    <message>
        <source>All files (*)</source>
        <translation>所有文件 (*)</translation>
    </message>
    <message>
        <source>Models (%1)</source>
        <extracomment>%1 are patterns such as &quot;*.fff *.txt&quot;</extracomment>
        <translation>模型 (%1)</translation>
    </message>
    <message>
        <source>Drawings (%1)</source>
        <translation>图稿 (%1)</translation>
    </message>
</context>
<context>
    <name>fff::ui::GizmoMarks</name>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>Right</source>
        <extracomment>the way to the right, along an arrow</extracomment>
        <translation>右</translation>
    </message>
    <message>
        <source>Up</source>
        <extracomment>the way up, along an arrow</extracomment>
        <translation>上</translation>
    </message>
    <message>
        <source>Out</source>
        <extracomment>the way out of the plane, towards whoever looks, along an arrow</extracomment>
        <translation>外</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>%1&#x202f;%</source>
        <translation>%1&#x202f;%</translation>
    </message>
    <message>
        <source>Copy: %1</source>
        <translation>副本：%1</translation>
    </message>
</context>
<context>
    <name>fff::ui::HelpPages</name>
    <message>
        <source>Keys</source>
        <translation>按键</translation>
    </message>
</context>
<context>
    <name>fff::ui::HelpWindow</name>
    <message>
        <source>Help</source>
        <translation>帮助</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>后退</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>页面</translation>
    </message>
    <message>
        <source>Save the keys as a page</source>
        <translation>把按键另存为一页</translation>
    </message>
    <message>
        <source>PDF documents (*.pdf)</source>
        <translation>PDF 文档 (*.pdf)</translation>
    </message>
    <message>
        <source>FlatFitFab keys</source>
        <translation>FlatFitFab 按键</translation>
    </message>
    <message>
        <source>%1 could not be written.</source>
        <translation>无法写入 %1。</translation>
    </message>
</context>
<context>
    <name>fff::ui::HistoryDock</name>
    <message>
        <source>History</source>
        <translation>历史</translation>
    </message>
    <message>
        <source>Every step; choosing one goes back to it.</source>
        <translation>全部步骤；选择一步就回到那里。</translation>
    </message>
    <message>
        <source>Every step will be listed here; go back to any of them.</source>
        <translation>每一步都会列在这里；可以回到任何一步。</translation>
    </message>
    <message>
        <source>Back to the beginning. Click a later step to do it again.</source>
        <translation>已回到开头。点击后面的步骤可重做。</translation>
    </message>
    <message>
        <source>The model is as it was after “%1”.</source>
        <translation>模型已回到“%1”之后的样子。</translation>
    </message>
    <message>
        <source>As it was opened</source>
        <translation>打开时的样子</translation>
    </message>
    <message>
        <source>New model</source>
        <translation>新模型</translation>
    </message>
    <message>
        <source>Saved here</source>
        <translation>在此保存</translation>
    </message>
</context>
<context>
    <name>fff::ui::InputRow</name>
    <message>
        <source>Delete removes a section; drag, or Alt with an arrow key, changes the order.</source>
        <translation>Del 移除插片；拖动或按 Alt 加方向键可更改顺序。</translation>
    </message>
    <message>
        <source>Remove it</source>
        <translation>移除它</translation>
    </message>
    <message>
        <source>%1 (deleted)</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1（已删除）</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>选择…</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>%1 is what an operation works on (&quot;Along&quot;), %2 the name of a section</extracomment>
        <translation>%1：%2</translation>
    </message>
</context>
<context>
    <name>fff::ui::InstanceGroup</name>
    <message>
        <source>Made by an operation</source>
        <translation>由操作生成</translation>
    </message>
    <message>
        <source>Made by</source>
        <translation>生成操作</translation>
    </message>
    <message>
        <source>Image of</source>
        <translation>原件</translation>
    </message>
    <message>
        <source>Leave this one out</source>
        <translation>略去这一个</translation>
    </message>
    <message>
        <source>Detach</source>
        <translation>分离</translation>
    </message>
    <message>
        <source>Turn this one into a drawn section; its operation still makes the others</source>
        <translation>把这一个变成手画的插片；其余的仍由它的操作生成</translation>
    </message>
    <message>
        <source>Made from</source>
        <translation>来源</translation>
    </message>
    <message>
        <source>Changes to one of them apply to all</source>
        <translation>改动其中一个，全部跟着变</translation>
    </message>
    <message>
        <source>Redraw it; everything made from it follows</source>
        <translation>重画它；由它生成的一切都跟着变</translation>
    </message>
</context>
<context>
    <name>fff::ui::JointPage</name>
    <message>
        <source>Joint</source>
        <translation>接头</translation>
    </message>
    <message>
        <source>Slits</source>
        <translation>插槽</translation>
    </message>
    <message>
        <source>Restore automatic settings</source>
        <translation>恢复自动设置</translation>
    </message>
    <message>
        <source>Sections</source>
        <translation>插片</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>Opens</source>
        <translation>开口</translation>
    </message>
    <message>
        <source>Flip the slits</source>
        <translation>翻转插槽</translation>
    </message>
    <message>
        <source>Slit</source>
        <translation>插槽</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>Meeting point</source>
        <translation>相接点</translation>
    </message>
    <message>
        <source>tab, %1 wide</source>
        <translation>榫头，宽 %1</translation>
    </message>
    <message>
        <source>closed, %1 long, %2 wide</source>
        <translation>封闭，长 %1，宽 %2</translation>
    </message>
    <message>
        <source>%1 deep, %2 wide</source>
        <translation>深 %1，宽 %2</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>%1 and %2 overlap.</source>
        <translation>%1 和 %2 重叠。</translation>
    </message>
    <message>
        <source>Trim %1</source>
        <translation>修剪 %1</translation>
    </message>
    <message>
        <source>Meeting point %1</source>
        <translation>相接点 %1</translation>
    </message>
    <message>
        <source>The slit of %1 takes this share of the depth, that of %2 the rest</source>
        <translation>%1 的插槽占深度的这个比例，其余归 %2 的插槽</translation>
    </message>
    <message>
        <source>Set by hand; automatic is 50&#x202f;%. %1</source>
        <translation>已手动设置；自动值为 50&#x202f;%。%1</translation>
    </message>
    <message>
        <source>Sections: %1 and %2</source>
        <translation>插片：%1 和 %2</translation>
    </message>
    <message>
        <source>Set by hand; the automatic setting can be restored</source>
        <translation>已手动设置；可恢复自动设置</translation>
    </message>
    <message>
        <source>%1 opens</source>
        <translation>%1 开口</translation>
    </message>
    <message>
        <source>The side that the slit of %1 opens to; that of %2 opens to the other</source>
        <translation>%1 的插槽开口的一侧；%2 的朝另一侧开口</translation>
    </message>
    <message>
        <source>In %1</source>
        <translation>在 %1 中</translation>
    </message>
    <message>
        <source>Let the program choose kind, direction and meeting points again</source>
        <translation>重新让程序决定类型、方向和相接点</translation>
    </message>
    <message>
        <source>Nothing of this joint is set by hand</source>
        <translation>这个接头没有手动设置</translation>
    </message>
</context>
<context>
    <name>fff::ui::JointRows</name>
    <message>
        <source>Select the joint with %1</source>
        <translation>选中与 %1 的接头</translation>
    </message>
    <message>
        <source>None yet</source>
        <translation>还没有</translation>
    </message>
</context>
<context>
    <name>fff::ui::JointWords</name>
    <message>
        <source>cross lap</source>
        <translation>十字搭接</translation>
    </message>
    <message>
        <source>extended cross lap</source>
        <translation>加长十字搭接</translation>
    </message>
    <message>
        <source>mortise</source>
        <translation>榫眼</translation>
    </message>
    <message>
        <source>tabs</source>
        <translation>榫头</translation>
    </message>
    <message>
        <source>no joint</source>
        <translation>无接头</translation>
    </message>
    <message>
        <source>Cross lap</source>
        <translation>十字搭接</translation>
    </message>
    <message>
        <source>Extended cross lap</source>
        <translation>加长十字搭接</translation>
    </message>
    <message>
        <source>Mortise</source>
        <translation>榫眼</translation>
    </message>
    <message>
        <source>Tabs</source>
        <translation>榫头</translation>
    </message>
    <message>
        <source>None</source>
        <translation>无</translation>
    </message>
    <message>
        <source>The clearance of their stock leaves a slit no width</source>
        <translation>材料的间隙使插槽没有宽度</translation>
    </message>
    <message>
        <source>Slits cannot open to the outside: a hole is in the way</source>
        <translation>插槽无法开到外面：有孔挡着</translation>
    </message>
    <message>
        <source>In one place they could only slide one way, in another only the other</source>
        <translation>有一处只能朝一个方向插，另一处只能朝反方向插</translation>
    </message>
    <message>
        <source>Nothing would hold them: holes are where slits would begin</source>
        <translation>没有东西能固定它们：插槽起点处正好是孔</translation>
    </message>
    <message>
        <source>One section reaches beyond the other, whichever way they slide</source>
        <translation>无论朝哪边插，总有一个插片超出另一个</translation>
    </message>
    <message>
        <source>Neither section reaches beyond the other</source>
        <translation>两个插片都没有超出对方</translation>
    </message>
    <message>
        <source>They meet in more than one place</source>
        <translation>它们相交不止一处</translation>
    </message>
    <message>
        <source>Neither section fits through a closed slit in the other</source>
        <translation>两个插片都穿不过对方的封闭插槽</translation>
    </message>
    <message>
        <source>One section only ends on the other</source>
        <translation>一个插片只是止于另一个</translation>
    </message>
    <message>
        <source>Neither section ends on the other&apos;s face</source>
        <translation>两个插片都没有止于对方的板面</translation>
    </message>
    <message>
        <source>There is no room for tabs and their slits</source>
        <translation>放不下榫头和它们的插槽</translation>
    </message>
    <message>
        <source>They meet at less than 30°</source>
        <translation>它们相交的角度小于 30°</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>向右</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>向左</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>向上</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>向下</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>向前</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>向后</translation>
    </message>
</context>
<context>
    <name>fff::ui::KeyRecorder</name>
    <message>
        <source>Press the keys</source>
        <translation>请按键</translation>
    </message>
</context>
<context>
    <name>fff::ui::KeysList</name>
    <message>
        <source>Keys</source>
        <translation>按键</translation>
    </message>
    <message>
        <source>Save them as a page to print…</source>
        <translation>另存为可打印的一页…</translation>
    </message>
    <message>
        <source>In the view</source>
        <translation>在视图中</translation>
    </message>
    <message>
        <source>Draw the first section</source>
        <translation>画第一个插片</translation>
    </message>
    <message>
        <source>drag in the middle</source>
        <translation>在中间拖动</translation>
    </message>
    <message>
        <source>Draw a section across another one</source>
        <translation>画一个横穿另一个的插片</translation>
    </message>
    <message>
        <source>drag out of it, go on</source>
        <translation>拖到外面，继续画</translation>
    </message>
    <message>
        <source>Turn the view</source>
        <translation>转动视图</translation>
    </message>
    <message>
        <source>drag beside the model</source>
        <translation>在模型旁边拖动</translation>
    </message>
    <message>
        <source>Come nearer</source>
        <translation>靠近</translation>
    </message>
    <message>
        <source>wheel</source>
        <translation>滚轮</translation>
    </message>
    <message>
        <source>Move the view</source>
        <translation>移动视图</translation>
    </message>
    <message>
        <source>drag with the middle button</source>
        <translation>按住中键拖动</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>选择</translation>
    </message>
    <message>
        <source>click</source>
        <translation>点击</translation>
    </message>
    <message>
        <source>Select a group</source>
        <translation>选择一组</translation>
    </message>
    <message>
        <source>Shift and drag</source>
        <translation>按住 Shift 拖动</translation>
    </message>
    <message>
        <source>Do what can be done with it</source>
        <translation>查看能做什么</translation>
    </message>
    <message>
        <source>right click</source>
        <translation>右键点击</translation>
    </message>
    <message>
        <source>Add a point</source>
        <translation>添加点</translation>
    </message>
    <message>
        <source>double click on the contour</source>
        <translation>双击轮廓</translation>
    </message>
    <message>
        <source>Draw without snapping</source>
        <translation>不吸附地画</translation>
    </message>
    <message>
        <source>hold Ctrl</source>
        <translation>按住 Ctrl</translation>
    </message>
</context>
<context>
    <name>fff::ui::LayoutGroup</name>
    <message>
        <source>Layout</source>
        <translation>排版</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>间距</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>边距</translation>
    </message>
    <message>
        <source>Stock</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>板材</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>旋转</translation>
    </message>
    <message>
        <source>Parts in holes</source>
        <translation>孔内放零件</translation>
    </message>
    <message>
        <source>Small parts may lie in the holes of large ones</source>
        <translation>小零件可以放在大零件的孔里</translation>
    </message>
</context>
<context>
    <name>fff::ui::LengthText</name>
    <message>
        <source>Millimetres</source>
        <translation>毫米</translation>
    </message>
    <message>
        <source>Centimetres</source>
        <translation>厘米</translation>
    </message>
    <message>
        <source>Inches</source>
        <translation>英寸</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>cm</source>
        <translation>cm</translation>
    </message>
    <message>
        <source>in</source>
        <translation>in</translation>
    </message>
</context>
<context>
    <name>fff::ui::LibraryDock</name>
    <message>
        <source>Part</source>
        <translation>零件</translation>
    </message>
    <message>
        <source>Library</source>
        <translation>零件库</translation>
    </message>
    <message>
        <source>Add selection</source>
        <translation>添加所选</translation>
    </message>
    <message>
        <source>Put the selection into the library; without one, the whole model</source>
        <translation>把所选内容放入零件库；没有选中时放入整个模型</translation>
    </message>
    <message>
        <source>Folder…</source>
        <translation>文件夹…</translation>
    </message>
    <message>
        <source>Choose the folder whose models are shown here</source>
        <translation>选择在这里显示哪个文件夹中的模型</translation>
    </message>
    <message>
        <source>Parts that you keep appear here: select some sections, then click Add selection.</source>
        <translation>你保留的零件会出现在这里：选中一些插片，再点击“添加所选”。</translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n 个插片</numerusform>
        </translation>
    </message>
    <message>
        <source>Library folder</source>
        <translation>零件库文件夹</translation>
    </message>
    <message>
        <source>Nothing added: nothing is drawn yet.</source>
        <translation>没有添加：还什么都没画。</translation>
    </message>
    <message>
        <source>The library folder %1 cannot be created.</source>
        <translation>无法创建零件库文件夹 %1。</translation>
    </message>
    <message>
        <source>%1 is in the library now.</source>
        <translation>%1 已放入零件库。</translation>
    </message>
    <message>
        <source>%1 is in the trash.</source>
        <translation>%1 已移到回收站。</translation>
    </message>
    <message>
        <source>%1 could not be moved to the trash.</source>
        <translation>%1 无法移到回收站。</translation>
    </message>
    <message>
        <source>Add it to the model</source>
        <translation>把它加到模型中</translation>
    </message>
    <message>
        <source>Move to trash</source>
        <translation>移到回收站</translation>
    </message>
</context>
<context>
    <name>fff::ui::LoadPage</name>
    <message>
        <source>Weight</source>
        <translation>重物</translation>
    </message>
    <message>
        <source>Push</source>
        <translation>推力</translation>
    </message>
    <message>
        <source>Where it acts</source>
        <translation>作用位置</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>物体</translation>
    </message>
    <message>
        <source>Plain weight</source>
        <translation>普通重物</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>质量</translation>
    </message>
    <message>
        <source>Also in kg, oz or lb: 1.5 kg, 2 lb</source>
        <translation>也可用 kg、oz 或 lb：1.5 kg、2 lb</translation>
    </message>
    <message>
        <source>ml</source>
        <translation>ml</translation>
    </message>
    <message>
        <source>Water in it</source>
        <translation>其中的水</translation>
    </message>
    <message>
        <source>Centre of mass</source>
        <translation>重心</translation>
    </message>
    <message>
        <source>Height above its place: the higher, the sooner the model tips over</source>
        <translation>高出放置处的距离：越高，模型越容易翻倒</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>力</translation>
    </message>
    <message>
        <source>10 N is about as much as 1 kg weighs</source>
        <translation>10 N 大约相当于 1 kg 的重量</translation>
    </message>
    <message>
        <source>Direction X</source>
        <translation>方向 X</translation>
    </message>
    <message>
        <source>Direction Y</source>
        <translation>方向 Y</translation>
    </message>
    <message>
        <source>Direction Z</source>
        <translation>方向 Z</translation>
    </message>
    <message>
        <source>On</source>
        <translation>所在插片</translation>
    </message>
    <message>
        <source>In the section&apos;s own plane, from its origin</source>
        <translation>在插片自己的平面内，从它的原点算起</translation>
    </message>
    <message>
        <source>Place X</source>
        <translation>位置 X</translation>
    </message>
    <message>
        <source>Place Y</source>
        <translation>位置 Y</translation>
    </message>
    <message>
        <source>Spread</source>
        <translation>分布</translation>
    </message>
    <message>
        <source>At a point</source>
        <translation>一个点上</translation>
    </message>
    <message>
        <source>Over a patch</source>
        <translation>一片区域</translation>
    </message>
    <message>
        <source>Along the edge</source>
        <translation>沿边缘</translation>
    </message>
    <message>
        <source>Hanging</source>
        <translation>悬挂</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>宽度</translation>
    </message>
    <message>
        <source>On copies too</source>
        <translation>副本也承载</translation>
    </message>
    <message>
        <source>Copies that operations make of its section carry one each</source>
        <translation>操作为它的插片生成的副本也各承载一份</translation>
    </message>
</context>
<context>
    <name>fff::ui::LoadTree</name>
    <message>
        <source>Weights and pushes</source>
        <translation>重物和推力</translation>
    </message>
    <message>
        <source>F2 renames, Del removes.</source>
        <translation>F2 重命名，Del 移除。</translation>
    </message>
    <message>
        <source>Weights</source>
        <translation>重物</translation>
    </message>
    <message>
        <source>Pushes</source>
        <translation>推力</translation>
    </message>
</context>
<context>
    <name>fff::ui::Loads</name>
    <message>
        <source>Push</source>
        <translation>推力</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>重物</translation>
    </message>
    <message>
        <source>%1&#x202f;N</source>
        <translation>%1&#x202f;N</translation>
    </message>
</context>
<context>
    <name>fff::ui::MagnetGroup</name>
    <message>
        <source>Template</source>
        <translation>参考物</translation>
    </message>
    <message>
        <source>Pulled in</source>
        <translation>磁吸</translation>
    </message>
    <message>
        <source>Bend the template into the plane of this section, so that the guides of others follow what was drawn</source>
        <translation>把参考物弯到这个插片的平面上，让其他插片的引导线跟随画出的形状</translation>
    </message>
    <message>
        <source>From within</source>
        <translation>磁吸距离</translation>
    </message>
</context>
<context>
    <name>fff::ui::MainToolBar</name>
    <message>
        <source>Tool bar</source>
        <translation>工具栏</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>重复</translation>
    </message>
    <message>
        <source>Repeat and blend sections</source>
        <translation>重复插片和在插片间过渡</translation>
    </message>
</context>
<context>
    <name>fff::ui::MainWindow</name>
    <message>
        <source>The model cannot be shown: the graphics driver offers no OpenGL 3.3. A newer driver may help.</source>
        <translation>无法显示模型：显卡驱动不支持 OpenGL 3.3。更新驱动也许有用。</translation>
    </message>
    <message>
        <source>The model cannot be shown on this display.</source>
        <translation>无法在这台显示设备上显示模型。</translation>
    </message>
    <message>
        <source>Start a new model, continue one, or look at a sample.</source>
        <translation>开始一个新模型，继续做一个，或看看示例。</translation>
    </message>
    <message numerus="yes">
        <source>Recovered: %n model(s) that were not saved</source>
        <translation>
            <numerusform>已找回：%n 个未保存的模型</numerusform>
        </translation>
    </message>
    <message>
        <source>Show them</source>
        <translation>显示它们</translation>
    </message>
    <message>
        <source>Recovered: %1</source>
        <extracomment>%1 is a model&apos;s name, how much was done, and when</extracomment>
        <translation>已找回：%1</translation>
    </message>
    <message>
        <source>Open it</source>
        <translation>打开它</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>丢弃</translation>
    </message>
    <message>
        <source>Show the folder</source>
        <translation>打开文件夹</translation>
    </message>
    <message>
        <source>This model is here to be adjusted. “Edit the design” brings all back.</source>
        <translation>这个模型供调整使用。“编辑设计”可恢复全部功能。</translation>
    </message>
    <message>
        <source>Help: %1</source>
        <extracomment>in the search: %1 is a heading of the help</extracomment>
        <translation>帮助：%1</translation>
    </message>
</context>
<context>
    <name>fff::ui::MakingGroup</name>
    <message>
        <source>Suggest sections</source>
        <translation>建议插片</translation>
    </message>
    <message>
        <source>How many</source>
        <translation>数量</translation>
    </message>
    <message>
        <source>Suggest</source>
        <translation>建议</translation>
    </message>
    <message>
        <source>Finds sections that show its form, hold each other and stand</source>
        <translation>找出能表现其形状、互相固定并站稳的插片</translation>
    </message>
    <message>
        <source>One more</source>
        <translation>再加一个</translation>
    </message>
    <message>
        <source>A section that fits among those there</source>
        <translation>在现有插片之间能加进的一个插片</translation>
    </message>
    <message>
        <source>Another</source>
        <translation>换一批</translation>
    </message>
    <message>
        <source>Other sections instead of the last</source>
        <translation>用别的插片代替上次的</translation>
    </message>
    <message>
        <source>Facets</source>
        <translation>面片</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>面数</translation>
    </message>
    <message>
        <source>Make facets</source>
        <translation>生成面片</translation>
    </message>
    <message>
        <source>Builds it of flat sheets with fingers along their edges. The mesh is simplified to so many faces first; those that lie flat together are one sheet.</source>
        <translation>用边缘带指接的平板拼成它。先把网格简化到这么多面；处在同一平面上的合为一张板材。</translation>
    </message>
    <message>
        <source>Unfold</source>
        <translation>展开</translation>
    </message>
    <message>
        <source>Lays it flat, to be cut of card in one piece or a few and folded along scored lines. Edges to join have the same number.</source>
        <translation>把它摊平，用卡纸切成一块或几块，再沿刻线折叠。要接起来的边编号相同。</translation>
    </message>
</context>
<context>
    <name>fff::ui::MarkGroup</name>
    <message>
        <source>Marks</source>
        <translation>标记</translation>
    </message>
    <message>
        <source>Words</source>
        <translation>文字</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Turned by</source>
        <translation>转动</translation>
    </message>
    <message>
        <source>Mark %1</source>
        <extracomment>%1 is a number</extracomment>
        <translation>标记 %1</translation>
    </message>
    <message>
        <source>Engraved</source>
        <translation>雕刻</translation>
    </message>
    <message>
        <source>Scored</source>
        <translation>刻线</translation>
    </message>
    <message>
        <source>Delete this mark</source>
        <translation>删除这个标记</translation>
    </message>
    <message>
        <source>Letter height</source>
        <translation>字高</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
</context>
<context>
    <name>fff::ui::MassEdit</name>
    <message>
        <source>g</source>
        <translation>g</translation>
    </message>
</context>
<context>
    <name>fff::ui::MeasureMarks</name>
    <message>
        <source>%1   X %2  Y %3  Z %4</source>
        <extracomment>a length, and how far it goes along X, Y and Z</extracomment>
        <translation>%1   X %2  Y %3  Z %4</translation>
    </message>
</context>
<context>
    <name>fff::ui::MeasureText</name>
    <message>
        <source>%1&#x202f;kg</source>
        <translation>%1&#x202f;kg</translation>
    </message>
    <message>
        <source>%1&#x202f;g</source>
        <translation>%1&#x202f;g</translation>
    </message>
    <message>
        <source>%1&#x202f;in²</source>
        <translation>%1&#x202f;in²</translation>
    </message>
    <message>
        <source>%1&#x202f;cm²</source>
        <translation>%1&#x202f;cm²</translation>
    </message>
</context>
<context>
    <name>fff::ui::MeshImport</name>
    <message>
        <source>Reading %1…</source>
        <translation>正在读取 %1…</translation>
    </message>
    <message>
        <source>%1 is too large for a model, so it was scaled to %2. Its size can be changed under Templates.</source>
        <extracomment>%1 is the name of a file, %2 a length</extracomment>
        <translation>%1 对模型来说太大，所以设成了 %2 大。大小可在“参考物”中更改。</translation>
    </message>
    <message>
        <source>%1 does not say its unit, so it was scaled to %2. Its size can be changed under Templates.</source>
        <extracomment>%1 is the name of a file, %2 a length</extracomment>
        <translation>%1 没有单位，所以设成了 %2 大。大小可在“参考物”中更改。</translation>
    </message>
    <message>
        <source>Meshes, pictures and drawings (%1)</source>
        <extracomment>%1 is a list of patterns such as *.stl</extracomment>
        <translation>网格、图片和图稿 (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>所有文件 (*)</translation>
    </message>
    <message>
        <source>Pasted picture</source>
        <translation>粘贴的图片</translation>
    </message>
    <message>
        <source>Scale it like %1</source>
        <extracomment>a button; %1 is the name of a mesh</extracomment>
        <translation>按 %1 的比例</translation>
    </message>
</context>
<context>
    <name>fff::ui::MessageBar</name>
    <message>
        <source>Message</source>
        <translation>消息</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>详情</translation>
    </message>
    <message>
        <source>Close this message</source>
        <translation>关闭这条消息</translation>
    </message>
    <message numerus="yes">
        <source>And %n more.</source>
        <translation>
            <numerusform>还有 %n 条。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::ModelPage</name>
    <message>
        <source>Model</source>
        <translation>模型</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大小</translation>
    </message>
    <message>
        <source>nothing drawn yet</source>
        <translation>还什么都没画</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>质量</translation>
    </message>
    <message>
        <source>New sections</source>
        <translation>新插片</translation>
    </message>
    <message>
        <source>Stock of the sections that are drawn next</source>
        <translation>接下来画的插片所用的材料</translation>
    </message>
    <message>
        <source>Edit the stock</source>
        <translation>编辑材料</translation>
    </message>
</context>
<context>
    <name>fff::ui::MovementRows</name>
    <message>
        <source>Movement</source>
        <translation>位移</translation>
    </message>
    <message>
        <source>Shows where the model bends or comes loose, larger than it is. Nothing is changed.</source>
        <translation>显示模型哪里弯曲或松脱，比实际夸大。不会改动任何东西。</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>播放</translation>
    </message>
    <message>
        <source>Motion is reduced: use the slider</source>
        <translation>动画已减少：请用滑块</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>暂停</translation>
    </message>
    <message>
        <source>It is not known how it moves.</source>
        <translation>不知道它会怎样移动。</translation>
    </message>
    <message>
        <source>Turn on “Sections bend” to see how it bends.</source>
        <translation>打开“插片可弯曲”，就能看到它怎样弯曲。</translation>
    </message>
    <message>
        <source>Shown as it begins to come apart.</source>
        <translation>显示的是它开始散开的样子。</translation>
    </message>
    <message>
        <source>Bends %1, shown %2 times as far.</source>
        <extracomment>%1 is a length, %2 a number of times</extracomment>
        <translation>弯曲 %1，放大 %2 倍显示。</translation>
    </message>
    <message>
        <source>Bends %1.</source>
        <translation>弯曲 %1。</translation>
    </message>
</context>
<context>
    <name>fff::ui::NamedNumberGroup</name>
    <message>
        <source>Named values</source>
        <translation>带名称的参数</translation>
    </message>
    <message>
        <source>A name is a word of letters and digits, other than “t” and the units.</source>
        <translation>名称是由字母和数字组成的词，不能是“t”或单位。</translation>
    </message>
    <message>
        <source>Delete this value</source>
        <translation>删除这个参数</translation>
    </message>
</context>
<context>
    <name>fff::ui::Naming</name>
    <message>
        <source>Section %1</source>
        <extracomment>the name of a section that nobody has named; %1 is its number</extracomment>
        <translation>插片 %1</translation>
    </message>
</context>
<context>
    <name>fff::ui::NumberEdit</name>
    <message>
        <source>mixed</source>
        <translation>多个值</translation>
    </message>
    <message>
        <source>At least %1.</source>
        <extracomment>%1 is the smallest value, with its unit</extracomment>
        <translation>最小 %1。</translation>
    </message>
    <message>
        <source>At most %1.</source>
        <extracomment>%1 is the largest value, with its unit</extracomment>
        <translation>最大 %1。</translation>
    </message>
</context>
<context>
    <name>fff::ui::OffcutRows</name>
    <message>
        <source>Offcut</source>
        <translation>余料</translation>
    </message>
    <message>
        <source>A sheet of another size, which is used up before whole ones</source>
        <translation>其他尺寸的板材，先于整张使用</translation>
    </message>
    <message>
        <source>From a drawing…</source>
        <translation>从图纸…</translation>
    </message>
    <message>
        <source>What is left of a sheet, as the largest outline of an SVG file in true size, with its holes</source>
        <translation>板材的剩余部分，即实际尺寸 SVG 文件中最大的轮廓线及其孔</translation>
    </message>
    <message>
        <source>Width of the offcut</source>
        <translation>余料宽度</translation>
    </message>
    <message>
        <source>Height of the offcut</source>
        <translation>余料高度</translation>
    </message>
    <message>
        <source>How many of this offcut</source>
        <translation>这种余料的数量</translation>
    </message>
    <message>
        <source>Take this offcut away</source>
        <translation>移除此余料</translation>
    </message>
    <message>
        <source>%1, from a drawing</source>
        <extracomment>%1 is the size of the box of an offcut with an outline of its own</extracomment>
        <translation>%1，来自图纸</translation>
    </message>
</context>
<context>
    <name>fff::ui::OperationMarks</name>
    <message>
        <source>%1 %2</source>
        <extracomment>%1 is the name of a number (&quot;From&quot;), %2 its value</extracomment>
        <translation>%1 %2</translation>
    </message>
</context>
<context>
    <name>fff::ui::OperationNotices</name>
    <message>
        <source>Choose another</source>
        <translation>另选一个</translation>
    </message>
    <message>
        <source>Show it</source>
        <translation>显示它</translation>
    </message>
    <message>
        <source>Allow more</source>
        <translation>允许更多</translation>
    </message>
    <message>
        <source>Keep it</source>
        <translation>保留</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>撤销</translation>
    </message>
    <message>
        <source>Choose</source>
        <translation>选择</translation>
    </message>
</context>
<context>
    <name>fff::ui::OperationPage</name>
    <message>
        <source>Exceptions</source>
        <translation>例外</translation>
    </message>
    <message>
        <source>Bake</source>
        <translation>定型</translation>
    </message>
    <message>
        <source>Turn what it makes into drawn sections; the operation itself is then gone</source>
        <translation>把它生成的内容变成手画的插片；操作本身随之消失</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Delete it and everything it makes</source>
        <translation>删除它和它生成的一切</translation>
    </message>
    <message>
        <source>Inputs</source>
        <translation>输入</translation>
    </message>
    <message>
        <source>Choose</source>
        <translation>选择</translation>
    </message>
    <message>
        <source>Allow more</source>
        <translation>允许更多</translation>
    </message>
</context>
<context>
    <name>fff::ui::OperationTree</name>
    <message>
        <source>Operations, in order</source>
        <translation>操作，按顺序</translation>
    </message>
    <message>
        <source>F2 renames, Space hides and shows, Alt with an arrow key changes the order.</source>
        <translation>F2 重命名，空格键隐藏和显示，Alt 加方向键更改顺序。</translation>
    </message>
    <message>
        <source>off</source>
        <translation>关</translation>
    </message>
    <message>
        <source>Hidden: show it</source>
        <translation>已隐藏：显示它</translation>
    </message>
    <message>
        <source>Hide it</source>
        <translation>隐藏它</translation>
    </message>
</context>
<context>
    <name>fff::ui::OutlineDock</name>
    <message>
        <source>Outline</source>
        <translation>大纲</translation>
    </message>
    <message>
        <source>Filter by name or stock</source>
        <translation>按名称或材料筛选</translation>
    </message>
    <message>
        <source>Sections</source>
        <translation>插片</translation>
    </message>
    <message>
        <source>F2 renames, Space hides and shows.</source>
        <translation>F2 重命名，空格键隐藏和显示。</translation>
    </message>
    <message>
        <source>Sections appear here as you draw them.</source>
        <translation>你画的插片会出现在这里。</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>重命名</translation>
    </message>
    <message>
        <source>%1, being drawn</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1，绘图中</translation>
    </message>
    <message>
        <source>Locked: unlock it</source>
        <translation>已锁定：解锁它</translation>
    </message>
    <message>
        <source>Lock it</source>
        <translation>锁定它</translation>
    </message>
    <message>
        <source>Hidden: show it</source>
        <translation>已隐藏：显示它</translation>
    </message>
    <message>
        <source>Hide it</source>
        <translation>隐藏它</translation>
    </message>
</context>
<context>
    <name>fff::ui::OverlayPainter</name>
    <message>
        <source>Draw a shape here with the left button held down.</source>
        <translation>按住左键，在这里画一个形状。</translation>
    </message>
    <message>
        <source>%1  %2</source>
        <extracomment>a problem: its number in the list, and what it is: &quot;3 Sections overlap&quot;</extracomment>
        <translation>%1  %2</translation>
    </message>
    <message numerus="yes">
        <source>%1, and %n more here</source>
        <translation>
            <numerusform>%1（此处还有 %n 个）</numerusform>
        </translation>
    </message>
    <message>
        <source>Working out the slits…</source>
        <translation>正在计算插槽…</translation>
    </message>
    <message>
        <source>X %1   Y %2</source>
        <extracomment>place of a point: %1 and %2 are numbers, the second has a unit</extracomment>
        <translation>X %1   Y %2</translation>
    </message>
    <message>
        <source>%1 × %2 from the last point</source>
        <extracomment>how far it is to the side (%1) and up or down (%2, with a unit)</extracomment>
        <translation>距上一个点 %1 × %2</translation>
    </message>
    <message>
        <source>Mirrored across the slit</source>
        <translation>沿插槽镜像</translation>
    </message>
    <message>
        <source>Mirrored across the vertical</source>
        <translation>沿竖直线镜像</translation>
    </message>
    <message>
        <source>Cut flat at the ground</source>
        <translation>在地面处切平</translation>
    </message>
    <message>
        <source>Ground %1 below this edge</source>
        <extracomment>%1 is a length</extracomment>
        <translation>地面在这条边下方 %1</translation>
    </message>
    <message>
        <source>Slit %1</source>
        <extracomment>%1 is its length, with a unit</extracomment>
        <translation>插槽 %1</translation>
    </message>
    <message>
        <source>Slit %1, %2</source>
        <extracomment>%1 is its length, with a unit; %2 says what it goes along: &quot;level&quot;</extracomment>
        <translation>插槽 %1，%2</translation>
    </message>
</context>
<context>
    <name>fff::ui::ParameterRow</name>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>As it follows from the sections</source>
        <translation>由插片得出的值</translation>
    </message>
    <message>
        <source>Set by hand</source>
        <translation>已手动设置</translation>
    </message>
</context>
<context>
    <name>fff::ui::PartsTable</name>
    <message>
        <source>Parts list</source>
        <translation>零件清单</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>编号</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>尺寸</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>面积</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>数量</translation>
    </message>
</context>
<context>
    <name>fff::ui::PhysicsDock</name>
    <message>
        <source>Physics</source>
        <translation>力学</translation>
    </message>
    <message>
        <source>Display</source>
        <translation>显示</translation>
    </message>
    <message>
        <source>Stress lines</source>
        <translation>应力线</translation>
    </message>
    <message>
        <source>Show from</source>
        <translation>显示下限</translation>
    </message>
    <message>
        <source>Share of the sheet&apos;s strength; less is not shown</source>
        <translation>占板材强度的比例；更小的不显示</translation>
    </message>
    <message>
        <source>finite elements</source>
        <translation>有限元</translation>
    </message>
    <message>
        <source>Sections bend</source>
        <translation>插片可弯曲</translation>
    </message>
    <message>
        <source>Where joints share a load, the stiffness of the sections decides how much each carries. Takes a while.</source>
        <translation>接头分担载荷时，各承受多少取决于插片的刚度。需要一些时间。</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Strength map</source>
        <translation>强度图</translation>
    </message>
    <message>
        <source>Colours the selected section by the mass that each place of it can hold, besides what is on the model already. Takes a while.</source>
        <translation>按选中插片各处还能承受的质量上色，不含模型上已有的载荷。需要一些时间。</translation>
    </message>
    <message>
        <source>Weakest places</source>
        <translation>最弱处</translation>
    </message>
    <message>
        <source>Loads</source>
        <translation>载荷</translation>
    </message>
    <message>
        <source>Put a weight on the model to see what it can hold.</source>
        <translation>在模型上放一个重物，看它能承受多少。</translation>
    </message>
    <message>
        <source>Own weight</source>
        <translation>自重</translation>
    </message>
    <message>
        <source>On the ground</source>
        <translation>地面承受</translation>
    </message>
    <message>
        <source>Add weight</source>
        <translation>添加重物</translation>
    </message>
    <message>
        <source>Add push</source>
        <translation>添加推力</translation>
    </message>
    <message>
        <source>How strict</source>
        <translation>严格程度</translation>
    </message>
    <message>
        <source>Safety factor</source>
        <translation>安全系数</translation>
    </message>
    <message>
        <source>How many times its load the model must be able to carry to count as holding</source>
        <translation>模型必须能承受载荷的多少倍，才算撑得住</translation>
    </message>
    <message>
        <source>Notch factor, at most</source>
        <translation>缺口系数上限</translation>
    </message>
    <message>
        <source>How far stress rises at inner corners follows from the length of the neck, up to this factor; slits with round ends need less</source>
        <translation>内角处应力升高多少由最窄处的长度决定，最多到这个倍数；圆头插槽需要的更小</translation>
    </message>
    <message>
        <source>for months</source>
        <translation>数月</translation>
    </message>
    <message>
        <source>Loads stay</source>
        <translation>载荷持续</translation>
    </message>
    <message>
        <source>A stock then holds less, as set for it: acrylic only a quarter</source>
        <translation>这时材料能承受的更少，按其设置计：亚克力只有四分之一</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <extracomment>what a weight or a push is called, and the section that it is on
----------
the name of a section, and a place in it such as &quot;at its neck&quot;</extracomment>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>Remove this push</source>
        <translation>移除这个推力</translation>
    </message>
    <message>
        <source>Remove this weight</source>
        <translation>移除这个重物</translation>
    </message>
    <message>
        <source>working… %1&#x202f;%</source>
        <translation>计算中… %1&#x202f;%</translation>
    </message>
    <message>
        <source>working…</source>
        <translation>计算中…</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>已停止</translation>
    </message>
    <message>
        <source>could not be worked out</source>
        <translation>无法算出</translation>
    </message>
    <message>
        <source>the selected section</source>
        <translation>选中的插片</translation>
    </message>
    <message>
        <source>select a section</source>
        <translation>请选中插片</translation>
    </message>
    <message>
        <source>Draw a section to see what it can hold.</source>
        <translation>画一个插片，看它能承受多少。</translation>
    </message>
    <message>
        <source>Whether it holds could not be worked out.</source>
        <translation>无法算出是否撑得住。</translation>
    </message>
    <message>
        <source>Older than the drawing, working…</source>
        <translation>结果已过时，计算中…</translation>
    </message>
    <message>
        <source>It does not stand; no stress is shown.</source>
        <translation>它站不稳；不显示应力。</translation>
    </message>
    <message>
        <source>A joint is pulled open; no stress is shown.</source>
        <translation>有接头被拉开；不显示应力。</translation>
    </message>
    <message>
        <source>Strength unknown: a stock is not rated. Set its strength under Stocks.</source>
        <translation>强度未知：有种材料未评定。请在“材料”中设置它的强度。</translation>
    </message>
    <message>
        <source>Up to date. Joints may share the load in many ways; the worst counts.</source>
        <translation>已是最新。接头分担载荷的方式可能有多种；按最不利的计。</translation>
    </message>
    <message>
        <source>Up to date. All forces balance.</source>
        <translation>已是最新。所有力都平衡。</translation>
    </message>
    <message>
        <source>%1 Bends %2.</source>
        <extracomment>the state of what is worked out, and a length</extracomment>
        <translation>%1弯曲 %2。</translation>
    </message>
    <message>
        <source>%1, %2: %3&#x202f;%</source>
        <extracomment>the name of a section, a place in it such as &quot;at its neck&quot;, a number of percent</extracomment>
        <translation>%1，%2：%3&#x202f;%</translation>
    </message>
</context>
<context>
    <name>fff::ui::PlaceGroup</name>
    <message>
        <source>across its slit</source>
        <translation>沿它的插槽</translation>
    </message>
    <message>
        <source>across the vertical</source>
        <translation>沿竖直线</translation>
    </message>
    <message>
        <source>across the horizontal</source>
        <translation>沿水平线</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>放置</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>脱离</translation>
    </message>
    <message>
        <source>It neither moves with the section that it is on, nor keeps its angle to it</source>
        <translation>既不跟着所在的插片移动，也不与它保持角度</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>锁定</translation>
    </message>
    <message>
        <source>It stays as it is, unless the section that it is on moves</source>
        <translation>保持不动，除非它所在的插片移动</translation>
    </message>
    <message>
        <source>Symmetric</source>
        <translation>对称</translation>
    </message>
    <message>
        <source>Changes to points of one half apply to the other</source>
        <translation>改动一半上的点，另一半也跟着变</translation>
    </message>
    <message>
        <source>On</source>
        <translation>所在插片</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Click another section to put it on</source>
        <translation>点击另一个插片，把它放上去</translation>
    </message>
    <message>
        <source>Not on another section</source>
        <translation>不在别的插片上</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Angle to it</source>
        <translation>与它的角度</translation>
    </message>
    <message>
        <source>Follows</source>
        <translation>跟随</translation>
    </message>
    <message>
        <source>in proportion</source>
        <translation>按比例</translation>
    </message>
    <message>
        <source>its left end</source>
        <translation>左端</translation>
    </message>
    <message>
        <source>its right end</source>
        <translation>右端</translation>
    </message>
    <message>
        <source>its lower end</source>
        <translation>下端</translation>
    </message>
    <message>
        <source>its upper end</source>
        <translation>上端</translation>
    </message>
    <message>
        <source>How its place follows when a value stretches the section that it is on: as far as that is stretched there, or at its distance from an end</source>
        <translation>参数拉伸它所在的插片时，它的位置怎样跟随：按该处的拉伸量，或与一端保持距离</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>X of its middle</source>
        <translation>中心 X</translation>
    </message>
    <message>
        <source>Y of its middle</source>
        <translation>中心 Y</translation>
    </message>
    <message>
        <source>Z of its middle</source>
        <translation>中心 Z</translation>
    </message>
    <message>
        <source>X of the direction it faces, of length 1</source>
        <translation>朝向的 X 分量，总长为 1</translation>
    </message>
    <message>
        <source>Y of the direction it faces, of length 1</source>
        <translation>朝向的 Y 分量，总长为 1</translation>
    </message>
    <message>
        <source>Z of the direction it faces, of length 1</source>
        <translation>朝向的 Z 分量，总长为 1</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>朝向</translation>
    </message>
</context>
<context>
    <name>fff::ui::PointGroup</name>
    <message>
        <source>Point</source>
        <translation>点</translation>
    </message>
    <message>
        <source>Handle in</source>
        <translation>入手柄</translation>
    </message>
    <message>
        <source>Angle in</source>
        <translation>入角</translation>
    </message>
    <message>
        <source>Handle out</source>
        <translation>出手柄</translation>
    </message>
    <message>
        <source>Angle out</source>
        <translation>出角</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>角点</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>平滑</translation>
    </message>
    <message>
        <source>Symmetric</source>
        <translation>对称</translation>
    </message>
</context>
<context>
    <name>fff::ui::PresetRow</name>
    <message>
        <source>Preset</source>
        <extracomment>a set of settings of a design&apos;s values that has a name, such as A5</extracomment>
        <translation>预设</translation>
    </message>
    <message>
        <source>changed</source>
        <extracomment>in place of a preset&apos;s name: what is set is none of them</extracomment>
        <translation>已改动</translation>
    </message>
    <message>
        <source>Name of the preset</source>
        <translation>预设的名称</translation>
    </message>
    <message>
        <source>A5, four shelves …</source>
        <extracomment>names of presets as they could be</extracomment>
        <translation>A5、四层搁板 …</translation>
    </message>
    <message>
        <source>Keep what is set now as a preset</source>
        <translation>把当前设置保留为预设</translation>
    </message>
    <message>
        <source>Delete this preset</source>
        <translation>删除这个预设</translation>
    </message>
    <message>
        <source>Keep as a preset</source>
        <translation>保留为预设</translation>
    </message>
    <message>
        <source>Gives what is set now a name, such as A5, to come back to it</source>
        <translation>给当前设置起个名称，例如 A5，以便再用</translation>
    </message>
</context>
<context>
    <name>fff::ui::ProblemMarks</name>
    <message>
        <source>%1 outside</source>
        <extracomment>%1 is a length: how far the centre of mass lies from the edge of the feet</extracomment>
        <translation>超出 %1</translation>
    </message>
    <message>
        <source>%1 inside</source>
        <extracomment>%1 is a length: how far it lies from their edge</extracomment>
        <translation>在内 %1</translation>
    </message>
    <message>
        <source>%1 too high</source>
        <extracomment>%1 is a length: how far a foot ends above the ground</extracomment>
        <translation>高了 %1</translation>
    </message>
</context>
<context>
    <name>fff::ui::PropertiesDock</name>
    <message>
        <source>Properties</source>
        <translation>属性</translation>
    </message>
    <message numerus="yes">
        <source>%n more in Checks.</source>
        <translation>
            <numerusform>检查中还有 %n 条。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::PropertiesHeader</name>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>On</source>
        <translation>启用</translation>
    </message>
    <message>
        <source>Switched off, it makes nothing but keeps its settings</source>
        <translation>关闭后它不生成内容，但保留设置</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <comment>joint</comment>
        <extracomment>the names of two sections that meet</extracomment>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <extracomment>%1 is a mass or a force, %2 the name of a section</extracomment>
        <translation>%2 上的 %1</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>模型</translation>
    </message>
    <message>
        <source>Nothing is selected</source>
        <translation>没有选中任何内容</translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n 个插片</numerusform>
        </translation>
    </message>
    <message>
        <source>Changes apply to all of them</source>
        <translation>改动对全部生效</translation>
    </message>
    <message>
        <source>They overlap</source>
        <translation>它们重叠</translation>
    </message>
    <message>
        <source>%1 · automatic</source>
        <translation>%1 · 自动</translation>
    </message>
    <message>
        <source>%1 · set by hand</source>
        <translation>%1 · 手动设置</translation>
    </message>
    <message numerus="yes">
        <source>%n joint(s)</source>
        <translation>
            <numerusform>%n 个接头</numerusform>
        </translation>
    </message>
    <message>
        <source>Made by %1 · %2</source>
        <extracomment>%1 is the name of an operation, %2 a number of joints</extracomment>
        <translation>由 %1 生成 · %2</translation>
    </message>
    <message>
        <source>Section · %1</source>
        <translation>插片 · %1</translation>
    </message>
    <message>
        <source>Section · on %1 · %2</source>
        <translation>插片 · 在 %1 上 · %2</translation>
    </message>
    <message>
        <source>%1 · switched off</source>
        <extracomment>%1 is the kind of an operation</extracomment>
        <translation>%1 · 已关闭</translation>
    </message>
    <message>
        <source>%1 · makes nothing</source>
        <extracomment>%1 is the kind of an operation</extracomment>
        <translation>%1 · 没有生成内容</translation>
    </message>
    <message>
        <source>%1 · %2 · up to date</source>
        <extracomment>%1 is the kind of an operation, %2 a number of sections</extracomment>
        <translation>%1 · %2 · 已是最新</translation>
    </message>
</context>
<context>
    <name>fff::ui::RecentMenu</name>
    <message>
        <source>Open &amp;recent</source>
        <translation>打开最近</translation>
    </message>
    <message>
        <source>%1 (missing)</source>
        <translation>%1（缺失）</translation>
    </message>
    <message>
        <source>&amp;Clear this list</source>
        <translation>清空列表</translation>
    </message>
    <message>
        <source>Forget these names; the files stay</source>
        <translation>忘掉这些名称；文件保留</translation>
    </message>
</context>
<context>
    <name>fff::ui::RemarkRows</name>
    <message>
        <source>What to look out for</source>
        <translation>要注意的地方</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>显示</translation>
    </message>
    <message>
        <source>Closes this and selects it in the model</source>
        <translation>关闭此窗口，并在模型中选中它</translation>
    </message>
</context>
<context>
    <name>fff::ui::ReplaceQuestion</name>
    <message>
        <source>Replace files</source>
        <translation>替换文件</translation>
    </message>
    <message numerus="yes">
        <source>Replace %n existing file(s)?</source>
        <translation>
            <numerusform>要替换 %n 个已有的文件吗？</numerusform>
        </translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>替换</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Replace this file?</source>
        <translation>要替换这个文件吗？</translation>
    </message>
</context>
<context>
    <name>fff::ui::SampleTexts</name>
    <message>
        <source>along</source>
        <translation>水平距离</translation>
    </message>
    <message>
        <source>Along a rib from ring to ring</source>
        <translation>沿肋片，从一个圆环到另一个圆环</translation>
    </message>
    <message>
        <source>Along a rib to the lower ring</source>
        <translation>沿肋片，到下圆环为止</translation>
    </message>
    <message>
        <source>Arch</source>
        <translation>桥拱</translation>
    </message>
    <message>
        <source>aside</source>
        <translation>偏移</translation>
    </message>
    <message>
        <source>axis_x</source>
        <translation>轴_x</translation>
    </message>
    <message>
        <source>axis_y</source>
        <translation>轴_y</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>背面</translation>
    </message>
    <message>
        <source>Beam</source>
        <translation>横梁</translation>
    </message>
    <message>
        <source>Beams</source>
        <translation>横梁组</translation>
    </message>
    <message>
        <source>Belly rib</source>
        <translation>腹部肋片</translation>
    </message>
    <message>
        <source>between</source>
        <translation>环间</translation>
    </message>
    <message>
        <source>Board</source>
        <translation>层板</translation>
    </message>
    <message>
        <source>Boards</source>
        <translation>层板组</translation>
    </message>
    <message>
        <source>boards</source>
        <translation>层板数</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>身体</translation>
    </message>
    <message>
        <source>Branch</source>
        <translation>树枝</translation>
    </message>
    <message>
        <source>capital</source>
        <translation>大写字高</translation>
    </message>
    <message>
        <source>Cells</source>
        <translation>格子</translation>
    </message>
    <message>
        <source>column</source>
        <translation>列距</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>列</translation>
    </message>
    <message>
        <source>columns</source>
        <translation>列数</translation>
    </message>
    <message>
        <source>Cradle</source>
        <translation>托架</translation>
    </message>
    <message>
        <source>cradle</source>
        <translation>托架高</translation>
    </message>
    <message>
        <source>Crest</source>
        <translation>顶饰板</translation>
    </message>
    <message>
        <source>Cutlery</source>
        <translation>餐具</translation>
    </message>
    <message>
        <source>depth</source>
        <translation>深度</translation>
    </message>
    <message>
        <source>diameter</source>
        <translation>直径</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>轴距</translation>
    </message>
    <message>
        <source>Divider</source>
        <translation>隔板</translation>
    </message>
    <message>
        <source>Dividers</source>
        <translation>隔板组</translation>
    </message>
    <message>
        <source>Ears</source>
        <translation>耳朵</translation>
    </message>
    <message>
        <source>Far base</source>
        <translation>远处底座</translation>
    </message>
    <message>
        <source>Far dancer</source>
        <translation>远处舞者</translation>
    </message>
    <message>
        <source>Far dancer, leaning</source>
        <translation>远处倾身舞者</translation>
    </message>
    <message>
        <source>Far dancers</source>
        <translation>远处的舞者们</translation>
    </message>
    <message>
        <source>Fir</source>
        <translation>冷杉</translation>
    </message>
    <message>
        <source>Fir across</source>
        <translation>横向冷杉</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>底板</translation>
    </message>
    <message>
        <source>Foot</source>
        <translation>支脚</translation>
    </message>
    <message>
        <source>Fore legs</source>
        <translation>前腿</translation>
    </message>
    <message>
        <source>Forks and teaspoons</source>
        <translation>叉子和茶匙</translation>
    </message>
    <message>
        <source>Four shelves</source>
        <translation>四层</translation>
    </message>
    <message>
        <source>From axis to axis, level</source>
        <translation>两轴之间的水平距离</translation>
    </message>
    <message>
        <source>From axis to axis, with some play</source>
        <translation>两轴之间的距离，留一点间隙</translation>
    </message>
    <message>
        <source>From wall to wall</source>
        <translation>相邻壁板之间的距离</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>正面</translation>
    </message>
    <message>
        <source>Front foot</source>
        <translation>前支脚</translation>
    </message>
    <message>
        <source>Front legs</source>
        <translation>前腿</translation>
    </message>
    <message>
        <source>Front rail</source>
        <translation>前横档</translation>
    </message>
    <message>
        <source>Front wave</source>
        <translation>前浪</translation>
    </message>
    <message>
        <source>Glass of water</source>
        <translation>一杯水</translation>
    </message>
    <message>
        <source>Handle</source>
        <translation>提手</translation>
    </message>
    <message>
        <source>Head</source>
        <translation>头部</translation>
    </message>
    <message>
        <source>height</source>
        <translation>高度</translation>
    </message>
    <message>
        <source>Height of the capitals; a long name has to be smaller</source>
        <translation>大写字母的高度；名字长时要小一些</translation>
    </message>
    <message>
        <source>Height of the cradles</source>
        <translation>托架的高度</translation>
    </message>
    <message>
        <source>Height of the pinion&apos;s axis</source>
        <translation>小齿轮轴的高度</translation>
    </message>
    <message>
        <source>Height of the wheel&apos;s axis</source>
        <translation>大齿轮轴的高度</translation>
    </message>
    <message>
        <source>Hind foot</source>
        <translation>后支脚</translation>
    </message>
    <message>
        <source>Hind legs</source>
        <translation>后腿</translation>
    </message>
    <message>
        <source>Hind wave</source>
        <translation>后浪</translation>
    </message>
    <message>
        <source>Hip</source>
        <translation>髋部</translation>
    </message>
    <message>
        <source>Horns</source>
        <translation>大颚</translation>
    </message>
    <message>
        <source>How far beside its place below a rib meets the upper ring</source>
        <translation>肋片与上圆环相接处，比它在下面的位置横向偏出多少</translation>
    </message>
    <message>
        <source>How far each rib leans</source>
        <translation>每片肋片倾斜多少</translation>
    </message>
    <message>
        <source>How much lower the pinion is, seen from the wheel</source>
        <translation>从大齿轮看，小齿轮低多少</translation>
    </message>
    <message>
        <source>How wide the plate is, in heights of a capital</source>
        <translation>名牌的宽度是大写字母高度的几倍</translation>
    </message>
    <message>
        <source>Its width</source>
        <translation>名牌的宽度</translation>
    </message>
    <message>
        <source>Jars</source>
        <translation>调料罐</translation>
    </message>
    <message>
        <source>Last rib</source>
        <translation>末尾肋片</translation>
    </message>
    <message>
        <source>Left foot</source>
        <translation>左脚</translation>
    </message>
    <message>
        <source>Left leaf</source>
        <translation>左叶</translation>
    </message>
    <message>
        <source>Left side</source>
        <translation>左侧板</translation>
    </message>
    <message>
        <source>Left strip</source>
        <translation>左条板</translation>
    </message>
    <message>
        <source>Left wing</source>
        <translation>左翅膀</translation>
    </message>
    <message>
        <source>Leg</source>
        <translation>腿</translation>
    </message>
    <message>
        <source>Legs</source>
        <translation>腿组</translation>
    </message>
    <message>
        <source>legs</source>
        <translation>腿数</translation>
    </message>
    <message>
        <source>letters</source>
        <translation>字高</translation>
    </message>
    <message>
        <source>Long foot</source>
        <translation>长支脚</translation>
    </message>
    <message>
        <source>lower</source>
        <translation>环下</translation>
    </message>
    <message>
        <source>Lower ring</source>
        <translation>下圆环</translation>
    </message>
    <message>
        <source>Lower slat</source>
        <translation>下靠背条</translation>
    </message>
    <message>
        <source>Middle</source>
        <translation>中间</translation>
    </message>
    <message>
        <source>Middle base</source>
        <translation>中间底座</translation>
    </message>
    <message>
        <source>Middle dancer</source>
        <translation>中间舞者</translation>
    </message>
    <message>
        <source>Middle dancer, leaning</source>
        <translation>中间倾身舞者</translation>
    </message>
    <message>
        <source>Middle dancers</source>
        <translation>中间的舞者们</translation>
    </message>
    <message>
        <source>Middle rib</source>
        <translation>中间肋片</translation>
    </message>
    <message>
        <source>module</source>
        <translation>模数</translation>
    </message>
    <message>
        <source>Mug</source>
        <translation>马克杯</translation>
    </message>
    <message>
        <source>Muzzle</source>
        <translation>口鼻</translation>
    </message>
    <message>
        <source>name</source>
        <translation>名字</translation>
    </message>
    <message>
        <source>Name plate</source>
        <translation>名牌</translation>
    </message>
    <message>
        <source>Near base</source>
        <translation>近处底座</translation>
    </message>
    <message>
        <source>Near dancer</source>
        <translation>近处舞者</translation>
    </message>
    <message>
        <source>Near dancer, leaning</source>
        <translation>近处倾身舞者</translation>
    </message>
    <message>
        <source>Near dancers</source>
        <translation>近处的舞者们</translation>
    </message>
    <message>
        <source>Neck</source>
        <translation>颈部</translation>
    </message>
    <message>
        <source>Of a rib, along it</source>
        <translation>沿肋片量的高度</translation>
    </message>
    <message>
        <source>Of the boards, from end to end</source>
        <translation>层板两端之间</translation>
    </message>
    <message>
        <source>Of the drawer, inside</source>
        <translation>抽屉的内尺寸</translation>
    </message>
    <message>
        <source>Of the glass</source>
        <translation>杯子的直径</translation>
    </message>
    <message>
        <source>Of the highest wall</source>
        <translation>最高的壁板的高度</translation>
    </message>
    <message>
        <source>Of the pinion, from a gap to the wheel</source>
        <translation>小齿轮从齿槽正对大齿轮处转过的角度</translation>
    </message>
    <message>
        <source>Of the pinion, likewise</source>
        <translation>小齿轮，同上</translation>
    </message>
    <message>
        <source>Of the sides</source>
        <translation>侧板的深度</translation>
    </message>
    <message>
        <source>Of the sides; the crest stands higher</source>
        <translation>侧板的高度；顶饰板更高</translation>
    </message>
    <message>
        <source>Of the wheel</source>
        <translation>大齿轮的数值</translation>
    </message>
    <message>
        <source>Of the wheel, to the ground of its gaps</source>
        <translation>大齿轮，到齿槽底部</translation>
    </message>
    <message>
        <source>Of the wheel, to the tips of its teeth</source>
        <translation>大齿轮，到齿顶</translation>
    </message>
    <message>
        <source>Other foot</source>
        <translation>另一侧支脚</translation>
    </message>
    <message>
        <source>Other pier</source>
        <translation>另一侧桥墩</translation>
    </message>
    <message>
        <source>Other rail</source>
        <translation>另一侧栏杆</translation>
    </message>
    <message>
        <source>Other side</source>
        <translation>另一侧侧板</translation>
    </message>
    <message>
        <source>Other sill</source>
        <translation>另一侧底梁</translation>
    </message>
    <message>
        <source>Other toe</source>
        <translation>另一侧脚趾</translation>
    </message>
    <message>
        <source>Pens</source>
        <translation>笔</translation>
    </message>
    <message>
        <source>phase</source>
        <translation>起始角</translation>
    </message>
    <message>
        <source>Pier</source>
        <translation>桥墩</translation>
    </message>
    <message>
        <source>Pinion</source>
        <translation>小齿轮</translation>
    </message>
    <message>
        <source>pinion</source>
        <translation>小齿轮齿数</translation>
    </message>
    <message>
        <source>Pinion teeth</source>
        <translation>小齿轮的齿</translation>
    </message>
    <message>
        <source>pinion_radius</source>
        <translation>小齿轮半径</translation>
    </message>
    <message>
        <source>pinion_root</source>
        <translation>小齿轮齿根半径</translation>
    </message>
    <message>
        <source>pinion_y</source>
        <translation>小齿轮_y</translation>
    </message>
    <message>
        <source>Plate</source>
        <translation>背甲片</translation>
    </message>
    <message>
        <source>plate</source>
        <translation>牌宽</translation>
    </message>
    <message>
        <source>Plates</source>
        <translation>背甲片组</translation>
    </message>
    <message>
        <source>radius</source>
        <translation>半径</translation>
    </message>
    <message>
        <source>Rail</source>
        <translation>栏杆</translation>
    </message>
    <message>
        <source>Ray</source>
        <translation>鳍条</translation>
    </message>
    <message>
        <source>Rays</source>
        <translation>鳍条组</translation>
    </message>
    <message>
        <source>Rear rib</source>
        <translation>后部肋片</translation>
    </message>
    <message>
        <source>rest</source>
        <translation>余量</translation>
    </message>
    <message>
        <source>Rib</source>
        <translation>肋片</translation>
    </message>
    <message>
        <source>Ribs</source>
        <translation>肋片组</translation>
    </message>
    <message>
        <source>ribs</source>
        <translation>肋片数</translation>
    </message>
    <message>
        <source>Right foot</source>
        <translation>右脚</translation>
    </message>
    <message>
        <source>Right leaf</source>
        <translation>右叶</translation>
    </message>
    <message>
        <source>Right side</source>
        <translation>右侧板</translation>
    </message>
    <message>
        <source>Right strip</source>
        <translation>右条板</translation>
    </message>
    <message>
        <source>Right wing</source>
        <translation>右翅膀</translation>
    </message>
    <message>
        <source>Ring</source>
        <translation>圆环</translation>
    </message>
    <message>
        <source>Ring of holes</source>
        <translation>一圈孔</translation>
    </message>
    <message>
        <source>root</source>
        <translation>齿根半径</translation>
    </message>
    <message>
        <source>row</source>
        <translation>行距</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>行</translation>
    </message>
    <message>
        <source>rows</source>
        <translation>行数</translation>
    </message>
    <message>
        <source>Screws</source>
        <translation>螺丝</translation>
    </message>
    <message>
        <source>Seat</source>
        <translation>座板</translation>
    </message>
    <message>
        <source>Shelf</source>
        <translation>搁板</translation>
    </message>
    <message>
        <source>Shoulder</source>
        <translation>肩部</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>侧板</translation>
    </message>
    <message>
        <source>Sides</source>
        <translation>侧板组</translation>
    </message>
    <message>
        <source>Sill</source>
        <translation>底梁</translation>
    </message>
    <message>
        <source>Size of the teeth: the diameter over their number</source>
        <translation>齿的大小：直径除以齿数</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>切片</translation>
    </message>
    <message>
        <source>Small glass</source>
        <translation>小玻璃杯</translation>
    </message>
    <message>
        <source>Spine</source>
        <translation>脊骨</translation>
    </message>
    <message>
        <source>Spoons and knives</source>
        <translation>勺子和餐刀</translation>
    </message>
    <message>
        <source>Star</source>
        <translation>星形</translation>
    </message>
    <message>
        <source>Sun</source>
        <translation>太阳</translation>
    </message>
    <message>
        <source>Tail</source>
        <translation>尾巴</translation>
    </message>
    <message>
        <source>Teeth</source>
        <translation>齿列</translation>
    </message>
    <message>
        <source>teeth</source>
        <translation>齿数</translation>
    </message>
    <message>
        <source>Teeth of the pinion</source>
        <translation>小齿轮的齿数</translation>
    </message>
    <message>
        <source>The same without whole teeth</source>
        <translation>同一角度，去掉整数个齿后的余量</translation>
    </message>
    <message>
        <source>Three shelves</source>
        <translation>三层</translation>
    </message>
    <message>
        <source>tilt</source>
        <translation>倾角</translation>
    </message>
    <message>
        <source>Timber</source>
        <translation>撑木</translation>
    </message>
    <message>
        <source>Timbers</source>
        <translation>撑木组</translation>
    </message>
    <message>
        <source>Toe</source>
        <translation>脚趾</translation>
    </message>
    <message>
        <source>Tooth</source>
        <translation>齿</translation>
    </message>
    <message>
        <source>Trunk</source>
        <translation>树干</translation>
    </message>
    <message>
        <source>Tumbler</source>
        <translation>直筒杯</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>转角</translation>
    </message>
    <message>
        <source>Twig</source>
        <translation>细枝</translation>
    </message>
    <message>
        <source>twist</source>
        <translation>扭转</translation>
    </message>
    <message>
        <source>Upper ring</source>
        <translation>上圆环</translation>
    </message>
    <message>
        <source>Upper slat</source>
        <translation>上靠背条</translation>
    </message>
    <message>
        <source>Vertebrae of the neck</source>
        <translation>颈椎</translation>
    </message>
    <message>
        <source>Vertebrae of the tail</source>
        <translation>尾椎</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>壁板</translation>
    </message>
    <message>
        <source>Whale</source>
        <translation>鲸鱼</translation>
    </message>
    <message>
        <source>What the sheet has room for</source>
        <translation>板材放得下的字高</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>大齿轮</translation>
    </message>
    <message>
        <source>Where a tooth of the wheel is</source>
        <translation>大齿轮的一个齿所在的位置</translation>
    </message>
    <message>
        <source>Wide</source>
        <translation>加宽</translation>
    </message>
    <message>
        <source>width</source>
        <translation>宽度</translation>
    </message>
    <message>
        <source>widths</source>
        <translation>宽比</translation>
    </message>
</context>
<context>
    <name>fff::ui::Samples</name>
    <message>
        <source>Fish</source>
        <translation>鱼</translation>
    </message>
    <message>
        <source>Dachshund</source>
        <translation>腊肠犬</translation>
    </message>
    <message>
        <source>Fir tree</source>
        <translation>冷杉</translation>
    </message>
    <message>
        <source>Lamp shade</source>
        <translation>灯罩</translation>
    </message>
    <message>
        <source>Doll’s chair</source>
        <translation>娃娃椅</translation>
    </message>
    <message>
        <source>Glass holder</source>
        <translation>杯托</translation>
    </message>
    <message>
        <source>Desk organiser</source>
        <translation>桌面收纳盒</translation>
    </message>
    <message>
        <source>Shelf</source>
        <translation>搁架</translation>
    </message>
    <message>
        <source>Drawer organiser</source>
        <translation>抽屉收纳格</translation>
    </message>
    <message>
        <source>Name plate</source>
        <translation>名牌</translation>
    </message>
    <message>
        <source>Glass stand</source>
        <translation>杯架</translation>
    </message>
    <message>
        <source>Bear over a mesh</source>
        <translation>照着网格画的熊</translation>
    </message>
    <message>
        <source>Owl from pictures</source>
        <translation>照着图片画的猫头鹰</translation>
    </message>
    <message>
        <source>Hedgehog in slices</source>
        <translation>切片刺猬</translation>
    </message>
    <message>
        <source>Fish bones</source>
        <translation>鱼骨</translation>
    </message>
    <message>
        <source>Dinosaur</source>
        <translation>恐龙</translation>
    </message>
    <message>
        <source>Stag beetle</source>
        <translation>锹甲</translation>
    </message>
    <message>
        <source>Growing tree</source>
        <translation>生长的树</translation>
    </message>
    <message>
        <source>Dancers in two poses</source>
        <translation>两种姿势的舞者</translation>
    </message>
    <message>
        <source>Footbridge</source>
        <translation>人行桥</translation>
    </message>
    <message>
        <source>Gears</source>
        <translation>齿轮</translation>
    </message>
    <message>
        <source>Whale in cells</source>
        <translation>分格鲸鱼</translation>
    </message>
    <message>
        <source>Cutlery man</source>
        <translation>餐具小人</translation>
    </message>
    <message>
        <source>Glass on three legs</source>
        <translation>三条腿上的杯子</translation>
    </message>
    <message>
        <source>Three thin legs: too weak</source>
        <translation>三条细腿：不够结实</translation>
    </message>
    <message>
        <source>Four thin legs: too weak</source>
        <translation>四条细腿：不够结实</translation>
    </message>
    <message>
        <source>Three thick legs: barely</source>
        <translation>三条粗腿：勉强</translation>
    </message>
    <message>
        <source>Four thick legs: safe</source>
        <translation>四条粗腿：安全</translation>
    </message>
</context>
<context>
    <name>fff::ui::ScaleBar</name>
    <message>
        <source>ft</source>
        <translation>ft</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
</context>
<context>
    <name>fff::ui::SearchWords</name>
    <message>
        <source>begin create empty blank</source>
        <translation>新建 开始 创建 空白 新模型</translation>
    </message>
    <message>
        <source>load import flatfab txt</source>
        <translation>载入 导入 读取 flatfab txt</translation>
    </message>
    <message>
        <source>add merge append combine</source>
        <translation>添加 合并 追加 组合</translation>
    </message>
    <message>
        <source>store write</source>
        <translation>存储 存盘 写入</translation>
    </message>
    <message>
        <source>copy rename</source>
        <translation>复制 改名 重命名 另存</translation>
    </message>
    <message>
        <source>reload discard</source>
        <translation>重新载入 放弃改动 还原</translation>
    </message>
    <message>
        <source>print laser cutter cnc plotter svg dxf pdf gcode lightburn make fabricate</source>
        <translation>打印 激光 切割机 雕刻机 数控 cnc 绘图仪 svg dxf pdf gcode lightburn 制作 加工 输出</translation>
    </message>
    <message>
        <source>preferences options configure dark light theme language units inches mouse navigation autosave animation</source>
        <translation>首选项 选项 配置 深色 浅色 主题 语言 中文 单位 英寸 鼠标 导航 自动保存 动画</translation>
    </message>
    <message>
        <source>keys hotkeys bindings</source>
        <translation>按键 热键 键盘 快捷键</translation>
    </message>
    <message>
        <source>exit leave</source>
        <translation>离开 关闭 结束</translation>
    </message>
    <message>
        <source>svg dxf import</source>
        <translation>svg dxf 导入</translation>
    </message>
    <message>
        <source>svg dxf import engrave</source>
        <translation>svg dxf 导入 雕刻</translation>
    </message>
    <message>
        <source>stl obj picture image photo trace reference background</source>
        <translation>stl obj 图片 图像 照片 描摹 描图 参考 底图 背景</translation>
    </message>
    <message>
        <source>back oops</source>
        <translation>返回 后退 取消 还原</translation>
    </message>
    <message>
        <source>again forward</source>
        <translation>再做 前进 恢复</translation>
    </message>
    <message>
        <source>clipboard</source>
        <translation>剪贴板</translation>
    </message>
    <message>
        <source>copy clone</source>
        <translation>复制 克隆 拷贝</translation>
    </message>
    <message>
        <source>flip reflect symmetric</source>
        <translation>翻转 反射 对称</translation>
    </message>
    <message>
        <source>remove erase trash</source>
        <translation>移除 清除 擦除 垃圾桶</translation>
    </message>
    <message>
        <source>everything</source>
        <translation>全部 所有</translation>
    </message>
    <message>
        <source>search palette</source>
        <translation>搜索 命令面板</translation>
    </message>
    <message>
        <source>zoom centre center home</source>
        <translation>缩放 居中 中心 全图</translation>
    </message>
    <message>
        <source>zoom focus</source>
        <translation>缩放 聚焦</translation>
    </message>
    <message>
        <source>look straight</source>
        <translation>正视 正面看</translation>
    </message>
    <message>
        <source>orthographic isometric parallel camera</source>
        <translation>正交 等轴测 平行 相机</translation>
    </message>
    <message>
        <source>transparent wireframe through</source>
        <translation>透明 线框 看穿</translation>
    </message>
    <message>
        <source>slice inside half</source>
        <translation>剖切 剖面 内部 一半</translation>
    </message>
    <message>
        <source>surface shell cover</source>
        <translation>曲面 表面 外壳 覆盖</translation>
    </message>
    <message>
        <source>solo alone</source>
        <translation>单独 孤立 独显</translation>
    </message>
    <message>
        <source>unhide visible</source>
        <translation>取消隐藏 可见</translation>
    </message>
    <message>
        <source>invisible</source>
        <translation>不可见 看不见</translation>
    </message>
    <message>
        <source>grid floor</source>
        <translation>栅格 方格 地板</translation>
    </message>
    <message>
        <source>share give customizer customise customize configure student class adjust sliders locked full window</source>
        <translation>分享 给别人 定制 自定义 配置 学生 班级 调整 滑块 锁定 整个窗口</translation>
    </message>
    <message>
        <source>maximise maximize</source>
        <translation>最大化</translation>
    </message>
    <message>
        <source>sidebars</source>
        <translation>侧栏 边栏</translation>
    </message>
    <message>
        <source>layout default</source>
        <translation>布局 默认</translation>
    </message>
    <message>
        <source>mirror half</source>
        <translation>镜像 一半</translation>
    </message>
    <message>
        <source>floor feet base</source>
        <translation>地板 脚 底部</translation>
    </message>
    <message>
        <source>magnet align guide</source>
        <translation>磁铁 捕捉 对齐 参考线</translation>
    </message>
    <message>
        <source>polygon line curve bezier path</source>
        <translation>多边形 线 曲线 贝塞尔 路径</translation>
    </message>
    <message>
        <source>circle square rectangle polygon star</source>
        <translation>圆 正方形 方形 矩形 多边形 星</translation>
    </message>
    <message>
        <source>engrave text letters etch label</source>
        <translation>刻字 文字 字母 蚀刻 标签</translation>
    </message>
    <message>
        <source>move rotate turn scale resize</source>
        <translation>移动 旋转 转动 缩放 调整大小</translation>
    </message>
    <message>
        <source>opening window cutout</source>
        <translation>开口 窗口 镂空 挖孔</translation>
    </message>
    <message>
        <source>replace</source>
        <translation>替换</translation>
    </message>
    <message>
        <source>array pattern repeat row ribs</source>
        <translation>阵列 重复 排列 肋片 线性</translation>
    </message>
    <message>
        <source>spin around</source>
        <translation>旋转 绕 环形</translation>
    </message>
    <message>
        <source>loft morph between</source>
        <translation>放样 变形 中间</translation>
    </message>
    <message>
        <source>tree fork</source>
        <translation>树 分叉 树枝</translation>
    </message>
    <message>
        <source>waffle crate lattice</source>
        <translation>网格 格子 格栅 华夫格 分割</translation>
    </message>
    <message>
        <source>spokes wheel gear polar</source>
        <translation>辐条 轮子 齿轮 极坐标</translation>
    </message>
    <message>
        <source>rotate polar pattern</source>
        <translation>旋转 极坐标 阵列</translation>
    </message>
    <message>
        <source>pattern repeat copies</source>
        <translation>阵列 重复 副本</translation>
    </message>
    <message>
        <source>waffle layers stl</source>
        <translation>华夫格 层叠 stl</translation>
    </message>
    <message>
        <source>convert explode apply</source>
        <translation>转换 炸开 分解 应用 固化 烘焙</translation>
    </message>
    <message>
        <source>error warning issue</source>
        <translation>错误 警告 问题</translation>
    </message>
    <message>
        <source>assembly instructions animation play manual</source>
        <translation>组装 装配 说明书 动画 播放 手册</translation>
    </message>
    <message>
        <source>strength break simulation physics fem</source>
        <translation>强度 断裂 模拟 物理 力学 有限元</translation>
    </message>
    <message>
        <source>load mass force</source>
        <translation>载荷 负重 质量 力 砝码</translation>
    </message>
    <message>
        <source>force load</source>
        <translation>力 载荷</translation>
    </message>
    <message>
        <source>material thickness plywood acrylic kerf</source>
        <translation>板材 厚度 胶合板 椴木板 亚克力 切缝</translation>
    </message>
    <message>
        <source>test piece kerf clearance slits comb</source>
        <translation>试件 测试 切缝 间隙 插槽 配合</translation>
    </message>
    <message>
        <source>nesting layout arrange</source>
        <translation>套料 排料 排样 排列 布局</translation>
    </message>
    <message>
        <source>length distance size dimension</source>
        <translation>长度 距离 大小 尺寸</translation>
    </message>
    <message>
        <source>scale size resize</source>
        <translation>缩放 大小 尺寸</translation>
    </message>
    <message>
        <source>manual tutorial documentation guide</source>
        <translation>手册 教程 文档 指南 说明</translation>
    </message>
    <message>
        <source>home welcome examples</source>
        <translation>主页 欢迎 例子 示例</translation>
    </message>
    <message>
        <source>version licence license</source>
        <translation>版本 许可证 授权</translation>
    </message>
</context>
<context>
    <name>fff::ui::SectionPage</name>
    <message>
        <source>Stock</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>接头</translation>
    </message>
    <message>
        <source>Edit the stock</source>
        <translation>编辑材料</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>厚度</translation>
    </message>
    <message>
        <source>Thickness of the stock: all sections of this stock follow</source>
        <translation>材料的厚度：所有用这种材料的插片都跟着变</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>质量</translation>
    </message>
    <message>
        <source>As all others</source>
        <translation>与其他相同</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>旋转</translation>
    </message>
    <message>
        <source>How its parts may be turned on the sheet: one that keeps to the grain lies as it is drawn, or by half turns</source>
        <translation>它的零件在板材上可以怎样转：要顺纹理的，就按所画放置，或转半圈</translation>
    </message>
    <message>
        <source>Another length stretches the contour about its slit, or its middle</source>
        <translation>改变长度会以它的插槽或中心为基准拉伸轮廓</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>宽度</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高度</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>面积</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>点</translation>
    </message>
    <message>
        <source>Holes</source>
        <translation>孔</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
</context>
<context>
    <name>fff::ui::SegmentedBox</name>
    <message>
        <source>%1: %2</source>
        <extracomment>%1 is the name of a choice (&quot;Side&quot;), %2 one of what can be chosen (&quot;Both&quot;)</extracomment>
        <translation>%1：%2</translation>
    </message>
</context>
<context>
    <name>fff::ui::SettingsDialog</name>
    <message>
        <source>Settings</source>
        <translation>设置</translation>
    </message>
    <message>
        <source>Groups of settings</source>
        <translation>设置分组</translation>
    </message>
    <message>
        <source>General</source>
        <translation>常规</translation>
    </message>
    <message>
        <source>View</source>
        <translation>视图</translation>
    </message>
    <message>
        <source>Checks</source>
        <translation>检查</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>Keyboard</source>
        <translation>键盘</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>Millimetres (mm)</source>
        <translation>毫米 (mm)</translation>
    </message>
    <message>
        <source>Centimetres (cm)</source>
        <translation>厘米 (cm)</translation>
    </message>
    <message>
        <source>Inches (in)</source>
        <translation>英寸 (in)</translation>
    </message>
    <message>
        <source>What is shown and typed. Files always hold millimetres.</source>
        <translation>显示和输入用的单位。文件中始终用毫米。</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>颜色</translation>
    </message>
    <message>
        <source>Same as the system</source>
        <translation>与系统相同</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>浅色</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>深色</translation>
    </message>
    <message>
        <source>High contrast</source>
        <translation>高对比度</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>语言</translation>
    </message>
    <message>
        <source>Takes effect after a restart.</source>
        <translation>重启后生效。</translation>
    </message>
    <message>
        <source>Show the start page at startup</source>
        <translation>启动时显示起始页</translation>
    </message>
    <message>
        <source>Turning time</source>
        <translation>转动时间</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>How long the view takes, while you draw, to turn to the new plane. With 0 it jumps.</source>
        <translation>绘图时，视图转到新平面要用多久。设为 0 则直接跳转。</translation>
    </message>
    <message>
        <source>View turns by</source>
        <translation>视图转角</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>At 90° you look straight at the new plane. With less, the section that you started on stays visible.</source>
        <translation>90° 时正对新平面。小一些则还能看到起笔的那个插片。</translation>
    </message>
    <message>
        <source>Strokes follow a template within</source>
        <translation>笔迹吸附参考物的距离</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Mouse buttons like</source>
        <translation>鼠标按键仿照</translation>
    </message>
    <message>
        <source>Which buttons turn, move and zoom the view. Ctrl with the left button always turns it, Space with the left button moves it.</source>
        <translation>用哪些按键转动、平移和缩放视图。Ctrl 加左键始终转动，空格键加左键平移。</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>动画</translation>
    </message>
    <message>
        <source>Always</source>
        <translation>总是</translation>
    </message>
    <message>
        <source>As little as possible</source>
        <translation>尽量少</translation>
    </message>
    <message>
        <source>With as little as possible, the view jumps instead of turning.</source>
        <translation>选“尽量少”时，视图直接跳转，不转动。</translation>
    </message>
    <message>
        <source>Stress colours for the colour-blind</source>
        <translation>色盲用应力配色</translation>
    </message>
    <message>
        <source>From light to dark instead of blue to red. Always so in high contrast.</source>
        <translation>从浅到深，而不是从蓝到红。高对比度时始终如此。</translation>
    </message>
    <message>
        <source>Warn about angles below</source>
        <translation>角度小于此值时警告</translation>
    </message>
    <message>
        <source>The flatter two sections meet, the wider their slits have to be.</source>
        <translation>两个插片相交得越平，插槽就要越宽。</translation>
    </message>
    <message>
        <source>Ignore overlaps below</source>
        <translation>忽略重叠，小于</translation>
    </message>
    <message>
        <source>An overlap of less than this is no problem.</source>
        <translation>小于此值的重叠不算问题。</translation>
    </message>
    <message>
        <source>Look for an order of assembly for</source>
        <translation>搜索拼装顺序的时间</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>In the background, after each change. Allow more time if the checks find no order.</source>
        <translation>每次改动后在后台进行。如果检查找不到顺序，请给更多时间。</translation>
    </message>
    <message>
        <source>Safety factor</source>
        <translation>安全系数</translation>
    </message>
    <message>
        <source>How many times its load a model has to hold before it counts as strong enough.</source>
        <translation>模型要能承受载荷的多少倍，才算够结实。</translation>
    </message>
    <message>
        <source>Notch factor, at most</source>
        <translation>缺口系数上限</translation>
    </message>
    <message>
        <source>How many times higher stress is taken to be at inner corners.</source>
        <translation>内角处的应力按升高多少倍计算。</translation>
    </message>
    <message>
        <source>Loads stay on for months</source>
        <translation>载荷持续数月</translation>
    </message>
    <message>
        <source>Back up unsaved work every</source>
        <translation>备份未保存内容，间隔</translation>
    </message>
    <message>
        <source>After a crash or a power cut you get it back, even if it was never saved. Your file is not touched.</source>
        <translation>崩溃或断电后可以找回，从未保存过的也行。不会动你的文件。</translation>
    </message>
    <message>
        <source>Keep the previous version when saving</source>
        <translation>保存时保留上一个版本</translation>
    </message>
    <message>
        <source>Simple window</source>
        <translation>简洁窗口</translation>
    </message>
    <message>
        <source>To draw, check and export; all else is out of the way.</source>
        <translation>只用来绘制、检查和导出，其余都收起来。</translation>
    </message>
</context>
<context>
    <name>fff::ui::Sheet</name>
    <message>
        <source>A4</source>
        <translation>A4</translation>
    </message>
    <message>
        <source>A3</source>
        <translation>A3</translation>
    </message>
    <message>
        <source>Letter</source>
        <translation>Letter</translation>
    </message>
    <message>
        <source>K40 laser</source>
        <translation>K40 激光机</translation>
    </message>
    <message>
        <source>12 × 20 in</source>
        <translation>12 × 20 in</translation>
    </message>
    <message>
        <source>Whole plywood board</source>
        <translation>整张胶合板</translation>
    </message>
</context>
<context>
    <name>fff::ui::SheetGroup</name>
    <message>
        <source>On the sheet</source>
        <translation>在板材上</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>板材</translation>
    </message>
    <message>
        <source>Position X, Y</source>
        <translation>位置 X、Y</translation>
    </message>
    <message>
        <source>Turned by</source>
        <translation>转动</translation>
    </message>
    <message>
        <source>keeps its place</source>
        <translation>保持原位</translation>
    </message>
    <message>
        <source>Pinned</source>
        <translation>固定</translation>
    </message>
    <message>
        <source>P pins and unpins the selected part among the sheets</source>
        <translation>在板材视图中，P 固定或取消固定选中的零件</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1/%2</translation>
    </message>
    <message>
        <source>too large for one</source>
        <translation>太大，板材放不下</translation>
    </message>
    <message>
        <source>%1, its first part</source>
        <extracomment>%1 is &quot;1 of 2&quot;</extracomment>
        <translation>%1，它的第一个零件</translation>
    </message>
</context>
<context>
    <name>fff::ui::SheetView</name>
    <message>
        <source>%1 mm, to check the size</source>
        <translation>%1 mm，用来核对尺寸</translation>
    </message>
    <message>
        <source>Sheet, as it will be cut</source>
        <translation>板材，切割出来就是这样</translation>
    </message>
    <message>
        <source>Plus and minus zoom, the arrow keys move it, Home shows all of it.</source>
        <translation>加号和减号缩放，方向键移动，Home 显示整张。</translation>
    </message>
    <message>
        <source>%1  %2</source>
        <extracomment>a part on a sheet: its number, and its section&apos;s name</extracomment>
        <translation>%1  %2</translation>
    </message>
    <message>
        <source>Offcut %1 stays whole</source>
        <extracomment>%1 is the size of what is left of a sheet</extracomment>
        <translation>余料 %1 保持完整</translation>
    </message>
</context>
<context>
    <name>fff::ui::SheetsDock</name>
    <message>
        <source>Sheets</source>
        <translation>板材</translation>
    </message>
    <message>
        <source>Quick</source>
        <translation>快速</translation>
    </message>
    <message>
        <source>Good</source>
        <translation>良好</translation>
    </message>
    <message>
        <source>Best</source>
        <translation>最佳</translation>
    </message>
    <message>
        <source>How well parts are laid</source>
        <translation>排版的精细程度</translation>
    </message>
    <message>
        <source>Quick lays all parts again. Good takes about ten seconds. Best goes on until you stop it.</source>
        <translation>“快速”重排所有零件。“良好”大约用十秒。“最佳”一直找下去，直到你停止。</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Split by Grid</source>
        <translation>用分格分开</translation>
    </message>
    <message>
        <source>Unpin all</source>
        <translation>全部取消固定</translation>
    </message>
    <message>
        <source>Draw a section and it will lie here, ready to cut.</source>
        <translation>画一个插片，它就会放在这里，随时可以切割。</translation>
    </message>
    <message>
        <source>Nesting…</source>
        <translation>正在排版…</translation>
    </message>
    <message>
        <source>Nesting again…</source>
        <translation>正在重新排版…</translation>
    </message>
    <message numerus="yes">
        <source>%n pinned part(s) had no room where they were.</source>
        <translation>
            <numerusform>%n 个固定的零件在原处放不下。</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 is too large for its sheet.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>%1 太大，它的板材放不下。</translation>
    </message>
    <message numerus="yes">
        <source>%1 and %n more are too large for their sheets.</source>
        <translation>
            <numerusform>%1 和另外 %n 个太大，它们的板材放不下。</numerusform>
        </translation>
    </message>
    <message>
        <source>Add an offcut</source>
        <translation>添加余料</translation>
    </message>
    <message numerus="yes">
        <source>%n sheet(s) more than there are</source>
        <translation>
            <numerusform>还缺 %n 张板材</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 · %2 of cutting</source>
        <extracomment>%1 are the parts, %2 is how far the machine cuts</extracomment>
        <translation>%1 · 切割 %2</translation>
    </message>
    <message>
        <source>keeps the best so far, %1 s</source>
        <extracomment>%1 are seconds</extracomment>
        <translation>保留目前最好的结果，%1 秒</translation>
    </message>
    <message>
        <source>Nesting… %1 % used</source>
        <extracomment>%1 is how much of the sheets is filled</extracomment>
        <translation>正在排版… 利用率 %1 %</translation>
    </message>
    <message>
        <source>%1 on %2 · %3 % used · %4 of cutting</source>
        <extracomment>%1 are the parts, %2 the sheets, %3 is how much of these is filled, %4 how far the machine cuts</extracomment>
        <translation>%1，%2 · 利用率 %3 % · 切割 %4</translation>
    </message>
</context>
<context>
    <name>fff::ui::SheetsView</name>
    <message>
        <source>Sheets, as they will be cut</source>
        <translation>板材，切割出来就是这样</translation>
    </message>
    <message>
        <source>Page Up and Page Down go from part to part, the arrow keys move a part by 1 mm, R turns it, P pins it. Plus and minus zoom, Home shows all sheets.</source>
        <translation>Page Up 和 Page Down 在零件间切换，方向键把零件移动 1 mm，R 转动它，P 固定它。加号和减号缩放，Home 显示所有板材。</translation>
    </message>
    <message>
        <source>%1 %2 · %3 · turned %4°</source>
        <extracomment>a part on a sheet: its number, its section&apos;s name, its size, and by how much it is turned</extracomment>
        <translation>%1 %2 · %3 · 转动 %4°</translation>
    </message>
    <message>
        <source>There is no room for it.</source>
        <translation>放不下。</translation>
    </message>
    <message>
        <source>It may not be turned by so little.</source>
        <translation>不允许转这么小的角度。</translation>
    </message>
    <message>
        <source>It lies as it is drawn.</source>
        <translation>它按所画放置。</translation>
    </message>
    <message>
        <source>Sheet %1 of %2</source>
        <translation>板材 %1/%2</translation>
    </message>
    <message>
        <source>Too large</source>
        <translation>太大</translation>
    </message>
    <message>
        <source>grain ↔</source>
        <translation>纹理 ↔</translation>
    </message>
    <message numerus="yes">
        <source> · %n part(s) · %1 % used</source>
        <extracomment>behind &quot;Sheet 1 of 2&quot;: %n parts lie on it, and cover so much of it</extracomment>
        <translation>
            <numerusform> · %n 个零件 · 利用率 %1 %</numerusform>
        </translation>
    </message>
    <message>
        <source>Offcut, sheet %1 of %2</source>
        <translation>余料，板材 %1 / %2</translation>
    </message>
    <message>
        <source>Pinned: stays where it lies. Click to unpin it.</source>
        <translation>已固定：留在原处。点击取消固定。</translation>
    </message>
    <message>
        <source>Drag a part elsewhere, or click it to select it.</source>
        <translation>拖动零件可移动它，点击可选中它。</translation>
    </message>
    <message>
        <source>Click to unpin &lt;b&gt;%1&lt;/b&gt;.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>点击取消固定 &lt;b&gt;%1&lt;/b&gt;。</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt; is too large for its sheet. Click to select it.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>&lt;b&gt;%1&lt;/b&gt; 超出板材大小。点击选中它。</translation>
    </message>
    <message>
        <source>Drag &lt;b&gt;%1&lt;/b&gt; elsewhere, or click to select it.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>拖动可移动 &lt;b&gt;%1&lt;/b&gt;，点击可选中它。</translation>
    </message>
    <message>
        <source>Drag &lt;b&gt;%1&lt;/b&gt; elsewhere. &lt;kbd&gt;R&lt;/kbd&gt; turns it, &lt;kbd&gt;P&lt;/kbd&gt; pins it.</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>拖动可移动 &lt;b&gt;%1&lt;/b&gt;。&lt;kbd&gt;R&lt;/kbd&gt; 旋转，&lt;kbd&gt;P&lt;/kbd&gt; 固定。</translation>
    </message>
</context>
<context>
    <name>fff::ui::ShortcutEditor</name>
    <message>
        <source>Filter by name or keys</source>
        <translation>按名称或按键筛选</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>No keys for this command</source>
        <translation>这个命令不用按键</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>重置</translation>
    </message>
    <message>
        <source>The original keys of this command</source>
        <translation>这个命令原来的按键</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>全部重置</translation>
    </message>
    <message>
        <source>The original keys of all commands</source>
        <translation>所有命令原来的按键</translation>
    </message>
    <message>
        <source>Use it here</source>
        <translation>用在这里</translation>
    </message>
    <message>
        <source>Commands and their shortcuts</source>
        <translation>命令及其快捷键</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>命令</translation>
    </message>
    <message>
        <source>Shortcut</source>
        <translation>快捷键</translation>
    </message>
    <message>
        <source>Works</source>
        <translation>范围</translation>
    </message>
    <message>
        <source>in the view</source>
        <translation>在视图中</translation>
    </message>
    <message>
        <source>everywhere</source>
        <translation>任何地方</translation>
    </message>
    <message>
        <source>Choose a command</source>
        <translation>选择一个命令</translation>
    </message>
    <message>
        <source>Keys for %1:</source>
        <translation>%1 的按键：</translation>
    </message>
    <message>
        <source>Changed by you</source>
        <translation>你改过</translation>
    </message>
    <message>
        <source>%1 alone would get in the way of typing. Hold Ctrl or Alt with it; single keys are for commands that work in the view.</source>
        <translation>单独的 %1 会妨碍打字。请同时按住 Ctrl 或 Alt；单个键只用于在视图中有效的命令。</translation>
    </message>
    <message>
        <source>%1 belongs to “%2”.</source>
        <translation>%1 属于“%2”。</translation>
    </message>
</context>
<context>
    <name>fff::ui::SkinPicture</name>
    <message>
        <source>Between %1 it would bulge far out: one more section across says how far.</source>
        <extracomment>%1 names the sections round a place</extracomment>
        <translation>%1 之间会鼓得很远：再加一个横穿的插片，就能说明鼓多远。</translation>
    </message>
    <message>
        <source>Between %1 it would fold over itself.</source>
        <translation>%1 之间会自己折叠起来。</translation>
    </message>
    <message>
        <source>What is between %1 cannot be told from their contours.</source>
        <translation>%1 之间是什么样，从它们的轮廓看不出来。</translation>
    </message>
    <message>
        <source>Skin: working… %1&#x202f;%</source>
        <translation>蒙皮：计算中… %1&#x202f;%</translation>
    </message>
    <message>
        <source>Skin: working…</source>
        <translation>蒙皮：计算中…</translation>
    </message>
    <message>
        <source>Skin: stopped</source>
        <translation>蒙皮：已停止</translation>
    </message>
    <message>
        <source>Skin: could not be worked out</source>
        <translation>蒙皮：无法算出</translation>
    </message>
    <message>
        <source>Skin</source>
        <translation>蒙皮</translation>
    </message>
    <message>
        <source>Skin: nothing to cover</source>
        <translation>蒙皮：没有可覆盖的</translation>
    </message>
    <message>
        <source>Skin: no contours cross</source>
        <translation>蒙皮：没有相交的轮廓</translation>
    </message>
    <message>
        <source>Click to stop.</source>
        <translation>点击停止。</translation>
    </message>
    <message>
        <source>A skin needs sections that cross each other and end in the same place there.</source>
        <translation>蒙皮需要相交的插片，并且它们在相交处的终点相同。</translation>
    </message>
    <message numerus="yes">
        <source>%n patches</source>
        <translation>
            <numerusform>%n 个曲面片</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1; %n places stay open.</source>
        <translation>
            <numerusform>%1；有 %n 处保持开口。</numerusform>
        </translation>
    </message>
    <message>
        <source>Click to see the sections alone again.</source>
        <translation>点击恢复为只看插片。</translation>
    </message>
</context>
<context>
    <name>fff::ui::SlitRows</name>
    <message>
        <source>Square</source>
        <translation>方形</translation>
    </message>
    <message>
        <source>Round</source>
        <translation>圆形</translation>
    </message>
    <message>
        <source>Dogbone</source>
        <translation>狗骨形</translation>
    </message>
    <message>
        <source>T-bone</source>
        <translation>T 骨形</translation>
    </message>
    <message>
        <source>Slit end</source>
        <translation>插槽末端</translation>
    </message>
    <message>
        <source>The inner end of a slit. A laser cuts it square; a mill&apos;s round tool cannot reach its corners. Round: a round bottom beyond the square one. Dogbone: an arc through each corner. T-bone: an arc in each wall; the bottom stays flat.</source>
        <translation>插槽的内端。激光能切成方形；铣床的圆刀具够不到角落。圆形：在方形底之外再加一个圆底。狗骨形：圆弧穿过每个角。T 骨形：每侧壁上有一个圆弧；底保持平直。</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>刀具</translation>
    </message>
    <message>
        <source>Diameter of the mill&apos;s tool. The arcs are drawn a little larger, so that it goes round them.</source>
        <translation>铣刀的直径。圆弧会画得略大一些，让刀具能绕过去。</translation>
    </message>
    <message>
        <source>A square end has no tool. Choose another slit end for a mill.</source>
        <translation>方形末端没有刀具。要用铣床，请选择别的插槽末端。</translation>
    </message>
    <message>
        <source>Lead-in</source>
        <translation>导入倒角</translation>
    </message>
    <message>
        <source>Chamfer of both walls at a slit&apos;s mouth, at 45°, so that sections slide in easily. Half to all of the thickness is usual; 0: none.</source>
        <translation>插槽口两侧壁上的 45° 倒角，让插片容易插入。通常为厚度的一半到全部；0：没有。</translation>
    </message>
    <message>
        <source>Friction bumps</source>
        <translation>摩擦凸点</translation>
    </message>
    <message>
        <source>Height of a small bump on each wall of a slit, which presses on the section in it. It has to be more than half of the clearance; 0: none.</source>
        <translation>插槽每侧壁上小凸点的高度，它会压住插在里面的插片。必须大于间隙的一半；0：没有。</translation>
    </message>
</context>
<context>
    <name>fff::ui::SpokenSelection</name>
    <message>
        <source>section</source>
        <translation>插片</translation>
    </message>
    <message>
        <source>generated section</source>
        <translation>生成的插片</translation>
    </message>
    <message>
        <source>on %1</source>
        <extracomment>%1 is the name of a section</extracomment>
        <translation>在 %1 上</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>已锁定</translation>
    </message>
    <message>
        <source>has a problem</source>
        <translation>有问题</translation>
    </message>
    <message>
        <source>no problem</source>
        <translation>没有问题</translation>
    </message>
    <message>
        <source>Joint of %1 and %2</source>
        <translation>%1 和 %2 的接头</translation>
    </message>
    <message>
        <source>%1, operation</source>
        <translation>%1，操作</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <extracomment>%1 is what a weight or a push is called, %2 the name of a section</extracomment>
        <translation>%2 上的 %1</translation>
    </message>
    <message numerus="yes">
        <source>%n sections selected</source>
        <translation>
            <numerusform>已选中 %n 个插片</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::StartPage</name>
    <message>
        <source>Start page</source>
        <translation>起始页</translation>
    </message>
    <message>
        <source>New</source>
        <translation>新建</translation>
    </message>
    <message>
        <source>Draw a model of your own</source>
        <translation>画一个你自己的模型</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>打开…</translation>
    </message>
    <message>
        <source>Open a model, also from FlatFab</source>
        <translation>打开一个模型，也可以是 FlatFab 的</translation>
    </message>
    <message>
        <source>No account, nothing leaves this computer.</source>
        <translation>不需要账号，任何内容都不会离开这台电脑。</translation>
    </message>
    <message>
        <source>Show at startup</source>
        <translation>启动时显示</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>最近</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>示例</translation>
    </message>
    <message>
        <source>Open it</source>
        <translation>打开它</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>丢弃</translation>
    </message>
    <message>
        <source>Recovered: %1</source>
        <extracomment>%1 is a model&apos;s name, how much was done, and when</extracomment>
        <translation>已找回：%1</translation>
    </message>
    <message>
        <source>Show the folder</source>
        <translation>打开文件夹</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>确定</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>缺失</translation>
    </message>
    <message>
        <source>Remove from this list</source>
        <translation>从列表中移除</translation>
    </message>
    <message>
        <source>Open a copy of it</source>
        <translation>打开它的副本</translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n 个插片</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, %2</source>
        <extracomment>%1 is a number of sections, %2 when it was opened last</extracomment>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>Your first model in 3 minutes</source>
        <translation>3 分钟做出第一个模型</translation>
    </message>
    <message>
        <source>Draw, check and cut a model, one step at a time</source>
        <translation>一步步画出、检查并切割一个模型</translation>
    </message>
</context>
<context>
    <name>fff::ui::StatusLine</name>
    <message>
        <source>What the next gesture does</source>
        <translation>下一个动作会做什么</translation>
    </message>
    <message>
        <source>Number of sections</source>
        <translation>插片数量</translation>
    </message>
    <message>
        <source>Size of the model</source>
        <translation>模型大小</translation>
    </message>
    <message>
        <source>Mass of the model</source>
        <translation>模型质量</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>Unit of all lengths</source>
        <translation>所有长度的单位</translation>
    </message>
    <message>
        <source>Undid “%1”.</source>
        <translation>已撤销“%1”。</translation>
    </message>
    <message>
        <source>Undid “%1”. &lt;kbd&gt;%2&lt;/kbd&gt; brings it back.</source>
        <translation>已撤销“%1”。&lt;kbd&gt;%2&lt;/kbd&gt; 恢复它。</translation>
    </message>
    <message>
        <source>Redid “%1”.</source>
        <translation>已重做“%1”。</translation>
    </message>
    <message>
        <source>Redid “%1”. &lt;kbd&gt;%2&lt;/kbd&gt; takes it back.</source>
        <translation>已重做“%1”。&lt;kbd&gt;%2&lt;/kbd&gt; 撤销它。</translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n 个插片</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::StepsBar</name>
    <message>
        <source>Steps of the assembly</source>
        <translation>拼装步骤</translation>
    </message>
    <message>
        <source>Export steps…</source>
        <translation>导出步骤…</translation>
    </message>
    <message>
        <source>Close the steps (Esc)</source>
        <translation>关闭步骤（Esc）</translation>
    </message>
    <message>
        <source>Previous step (Left)</source>
        <translation>上一步（←）</translation>
    </message>
    <message>
        <source>Play (Space)</source>
        <translation>播放（空格）</translation>
    </message>
    <message>
        <source>Next step (Right)</source>
        <translation>下一步（→）</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>步骤</translation>
    </message>
    <message>
        <source>Pull the parts apart</source>
        <translation>把零件拉开</translation>
    </message>
    <message>
        <source>Exploded</source>
        <translation>分解</translation>
    </message>
    <message>
        <source>Pause (Space)</source>
        <translation>暂停（空格）</translation>
    </message>
    <message>
        <source>Write all steps to a PDF to print, a web page for phones, or a picture of each</source>
        <translation>把全部步骤写成可打印的 PDF、适合手机的网页，或每步一张图片</translation>
    </message>
</context>
<context>
    <name>fff::ui::StepsExport</name>
    <message>
        <source>All steps, to print (*.pdf)</source>
        <translation>全部步骤，用于打印 (*.pdf)</translation>
    </message>
    <message>
        <source>Pictures, one for each step (*.png)</source>
        <translation>图片，每步一张 (*.png)</translation>
    </message>
    <message>
        <source>Export steps</source>
        <translation>导出步骤</translation>
    </message>
    <message>
        <source>Exporting %1…</source>
        <translation>正在导出 %1…</translation>
    </message>
    <message>
        <source>Nothing was written: the export was cancelled.</source>
        <translation>没有写入任何内容：导出已取消。</translation>
    </message>
    <message>
        <source>The steps could not be exported: no picture can be made on this display.</source>
        <translation>无法导出步骤：在这台显示设备上无法生成图片。</translation>
    </message>
    <message numerus="yes">
        <source>%n step(s)</source>
        <translation>
            <numerusform>%n 步</numerusform>
        </translation>
    </message>
    <message>
        <source>Exported %1 to %2.</source>
        <translation>已将 %1导出到 %2。</translation>
    </message>
    <message>
        <source>Exported %1 to %2 … %3.</source>
        <translation>已将 %1导出到 %2 … %3。</translation>
    </message>
    <message>
        <source>Export somewhere else…</source>
        <translation>导出到别处…</translation>
    </message>
    <message>
        <source>Web page (*.html)</source>
        <translation>网页 (*.html)</translation>
    </message>
</context>
<context>
    <name>fff::ui::StepsPage</name>
    <message>
        <source>This browser does not show the model in 3D. Here is what to do, step by step.</source>
        <translation>此浏览器无法以 3D 显示模型。下面逐步说明怎样做。</translation>
    </message>
    <message>
        <source>There are no pictures: none could be made on the display of the computer that wrote this page.</source>
        <translation>没有图片：写出此网页的计算机的显示设备无法生成图片。</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>编号</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>尺寸</translation>
    </message>
    <message>
        <source>Stock</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>Drag to turn the model, pinch or scroll to zoom, tap twice to see all of it.</source>
        <translation>拖动可转动模型，双指或滚轮可缩放，点两下可看全貌。</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>播放</translation>
    </message>
    <message>
        <source>Finished</source>
        <translation>完成</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>暂停</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>步骤</translation>
    </message>
    <message>
        <source>Previous step</source>
        <translation>上一步</translation>
    </message>
    <message>
        <source>Next step</source>
        <translation>下一步</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>零件</translation>
    </message>
</context>
<context>
    <name>fff::ui::StepsPaper</name>
    <message>
        <source>1 part</source>
        <translation>1 个零件</translation>
    </message>
    <message numerus="yes">
        <source>%n parts</source>
        <translation>
            <numerusform>%n 个零件</numerusform>
        </translation>
    </message>
    <message>
        <source>1 sheet</source>
        <translation>1 张板材</translation>
    </message>
    <message numerus="yes">
        <source>%n sheets</source>
        <translation>
            <numerusform>%n 张板材</numerusform>
        </translation>
    </message>
    <message>
        <source>1 step</source>
        <translation>1 步</translation>
    </message>
    <message numerus="yes">
        <source>%n steps</source>
        <translation>
            <numerusform>%n 步</numerusform>
        </translation>
    </message>
    <message>
        <source>Page %1 of %2</source>
        <translation>第 %1 页，共 %2 页</translation>
    </message>
    <message>
        <source>How it goes together</source>
        <translation>怎样拼装</translation>
    </message>
    <message>
        <source>%1, from %2, in %3.</source>
        <extracomment>%1 is &quot;38 parts&quot;, %2 &quot;2 sheets&quot;, %3 &quot;38 steps&quot;</extracomment>
        <translation>%1，取自 %2，分 %3完成。</translation>
    </message>
    <message>
        <source>The numbers are those engraved on the parts. At every slit there is the number of its joint after a short bar, the same on both of its parts.</source>
        <translation>编号与零件上雕刻的相同。每个插槽旁的短线后面是接头的编号，相接的两个零件上编号相同。</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>另外 %n 个</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, in %2.</source>
        <extracomment>%1 is &quot;38 parts&quot;, %2 &quot;38 steps&quot;</extracomment>
        <translation>%1，分 %2完成。</translation>
    </message>
</context>
<context>
    <name>fff::ui::StepsView</name>
    <message>
        <source>The model has changed, so its steps are not shown.</source>
        <translation>模型已改动，所以不显示步骤。</translation>
    </message>
    <message>
        <source>The steps cannot be shown on this display.</source>
        <translation>无法在这台显示设备上显示步骤。</translation>
    </message>
    <message>
        <source>The steps will not be shown.</source>
        <translation>不会显示步骤。</translation>
    </message>
    <message>
        <source>Working out the order of assembly; the steps are shown as soon as it is known.</source>
        <translation>正在计算拼装顺序；算出后就会显示步骤。</translation>
    </message>
    <message>
        <source>The steps cannot be shown: %1.</source>
        <extracomment>%1 is a sentence</extracomment>
        <translation>无法显示步骤：%1。</translation>
    </message>
    <message>
        <source>The order of assembly is known now; “Show the steps” shows it.</source>
        <translation>拼装顺序已算出；用“显示步骤”查看。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Nothing is there yet.&lt;/b&gt; Step 1: %1</source>
        <translation>&lt;b&gt;还什么都没有。&lt;/b&gt;第 1 步：%1</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1:&lt;/b&gt; %2</source>
        <extracomment>%1 is &quot;Step 4 of 38&quot;, %2 what is done in it</extracomment>
        <translation>&lt;b&gt;%1：&lt;/b&gt;%2</translation>
    </message>
</context>
<context>
    <name>fff::ui::Stock</name>
    <message>
        <source>Birch plywood</source>
        <translation>桦木胶合板</translation>
    </message>
    <message>
        <source>Birch plywood 4 mm</source>
        <translation>桦木胶合板 4 mm</translation>
    </message>
    <message>
        <source>Birch plywood 6.5 mm</source>
        <translation>桦木胶合板 6.5 mm</translation>
    </message>
    <message>
        <source>Birch plywood 9 mm</source>
        <translation>桦木胶合板 9 mm</translation>
    </message>
    <message>
        <source>MDF</source>
        <translation>MDF（中纤板）</translation>
    </message>
    <message>
        <source>Acrylic</source>
        <translation>亚克力</translation>
    </message>
    <message>
        <source>Acrylic, clear</source>
        <translation>亚克力，透明</translation>
    </message>
    <message>
        <source>Acrylic, red</source>
        <translation>亚克力，红色</translation>
    </message>
    <message>
        <source>Corrugated board B</source>
        <translation>瓦楞纸板 B</translation>
    </message>
    <message>
        <source>Corrugated board C</source>
        <translation>瓦楞纸板 C</translation>
    </message>
    <message>
        <source>Corrugated board E</source>
        <translation>瓦楞纸板 E</translation>
    </message>
    <message>
        <source>Card</source>
        <translation>卡纸</translation>
    </message>
    <message>
        <source>Basswood</source>
        <translation>椴木</translation>
    </message>
    <message>
        <source>POM</source>
        <translation>POM（赛钢）</translation>
    </message>
    <message>
        <source>Aluminium 6061</source>
        <translation>铝 6061</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Use %1 for new sections</source>
        <translation>新插片使用 %1</translation>
    </message>
    <message>
        <source>%1: %2 → %3 thick</source>
        <extracomment>a step of the history; %1 is a stock, %2 and %3 are lengths</extracomment>
        <translation>%1：厚度 %2 → %3</translation>
    </message>
</context>
<context>
    <name>fff::ui::StockBox</name>
    <message>
        <source>Stock of the next section</source>
        <translation>下一个插片的材料</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>厚度</translation>
    </message>
    <message>
        <source>Stock of the next section: %1</source>
        <translation>下一个插片的材料：%1</translation>
    </message>
    <message>
        <source>Stocks…</source>
        <translation>材料…</translation>
    </message>
</context>
<context>
    <name>fff::ui::StockEditor</name>
    <message>
        <source>Stocks</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
</context>
<context>
    <name>fff::ui::StockFields</name>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>板材</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>厚度</translation>
    </message>
    <message>
        <source>Sheet W × H</source>
        <translation>板材宽 × 高</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>密度</translation>
    </message>
    <message>
        <source>kg/m³</source>
        <translation>kg/m³</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>0 means not known</source>
        <translation>0 表示未知</translation>
    </message>
    <message>
        <source>Price of a sheet</source>
        <translation>每张板材价格</translation>
    </message>
    <message>
        <source>Width of the sheet</source>
        <translation>板材宽度</translation>
    </message>
    <message>
        <source>Height of the sheet</source>
        <translation>板材高度</translation>
    </message>
    <message>
        <source>Common sheets</source>
        <translation>常用板材</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>强度</translation>
    </message>
    <message>
        <source>Tensile strength</source>
        <translation>抗拉强度</translation>
    </message>
    <message>
        <source>MPa</source>
        <translation>MPa</translation>
    </message>
    <message>
        <source>Flexural strength</source>
        <translation>抗弯强度</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>刚度</translation>
    </message>
    <message>
        <source>GPa</source>
        <translation>GPa</translation>
    </message>
    <message>
        <source>before it breaks</source>
        <translation>断裂前先弯曲</translation>
    </message>
    <message>
        <source>Bends</source>
        <translation>弯曲</translation>
    </message>
    <message>
        <source>Like metal: above these strengths it stays bent</source>
        <translation>像金属：超过这些强度就会弯着回不去</translation>
    </message>
    <message>
        <source>Holds for months</source>
        <translation>长期强度</translation>
    </message>
    <message>
        <source>Share of its strength under a load that stays: acrylic creeps and crazes</source>
        <translation>载荷持续不去时还剩多少强度：亚克力会蠕变并产生银纹</translation>
    </message>
    <message>
        <source>Cutting</source>
        <translation>切割</translation>
    </message>
    <message>
        <source>Kerf width (full)</source>
        <translation>切缝宽度（全宽）</translation>
    </message>
    <message>
        <source>Slit clearance</source>
        <translation>插槽间隙</translation>
    </message>
    <message>
        <source>Drawn slit width</source>
        <translation>所画插槽宽</translation>
    </message>
    <message>
        <source>Slits</source>
        <translation>插槽</translation>
    </message>
    <message>
        <source>not rated</source>
        <translation>未评定</translation>
    </message>
    <message>
        <source>0 means not rated</source>
        <translation>0 表示未评定</translation>
    </message>
    <message>
        <source>No sections are made of it</source>
        <translation>没有用它做的插片</translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n 个插片</numerusform>
        </translation>
    </message>
    <message>
        <source>none: the kerf is wider than the slit</source>
        <translation>无：切缝比插槽宽</translation>
    </message>
    <message>
        <source>Thickness, clearance and kerf of two sections of this stock that stand square on each other</source>
        <translation>由两个互相垂直、同为此材料的插片的厚度、间隙和切缝得出</translation>
    </message>
    <message>
        <source>Sold as</source>
        <translation>标称厚度</translation>
    </message>
    <message>
        <source>The thickness by which the sheet is bought; as a rule it is not quite that</source>
        <translation>购买板材时的厚度；通常并不完全相符</translation>
    </message>
    <message>
        <source>with calipers, by me</source>
        <translation>由我用卡尺测量</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>实测</translation>
    </message>
    <message>
        <source>Export asks once how thick the sheets are that you will cut</source>
        <translation>导出时会询问一次您要切割的板材有多厚</translation>
    </message>
    <message>
        <source>as many as it takes</source>
        <translation>按需要</translation>
    </message>
    <message>
        <source>0 means as many as it takes</source>
        <translation>0 表示按需要</translation>
    </message>
    <message>
        <source>How many there are</source>
        <translation>现有数量</translation>
    </message>
    <message>
        <source>Used up first</source>
        <translation>优先使用</translation>
    </message>
    <message>
        <source>An offcut from a drawing</source>
        <translation>来自图纸的余料</translation>
    </message>
    <message>
        <source>Drawings (%1)</source>
        <translation>图稿 (%1)</translation>
    </message>
    <message>
        <source>By machine</source>
        <translation>按机器</translation>
    </message>
    <message>
        <source>Kept where a kerf was typed while that machine was chosen in Export</source>
        <translation>在导出中选择该机器时输入的切缝</translation>
    </message>
    <message>
        <source>Size and number</source>
        <translation>尺寸和数量</translation>
    </message>
</context>
<context>
    <name>fff::ui::StockList</name>
    <message>
        <source>Stocks of this model</source>
        <translation>这个模型的材料</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>添加</translation>
    </message>
    <message>
        <source>Add a stock from the presets</source>
        <translation>从预设中添加材料</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>创建副本</translation>
    </message>
    <message>
        <source>Add a stock with the same numbers</source>
        <translation>添加一种数值相同的材料</translation>
    </message>
    <message>
        <source>Save this stock in a file, for other models and other people</source>
        <translation>把这种材料存成文件，供其他模型和其他人使用</translation>
    </message>
    <message>
        <source>Save the stock in a file</source>
        <translation>把材料存成文件</translation>
    </message>
    <message>
        <source>Remove the stock</source>
        <translation>移除材料</translation>
    </message>
    <message numerus="yes">
        <source>%n section(s)</source>
        <translation>
            <numerusform>%n 个插片</numerusform>
        </translation>
    </message>
    <message>
        <source>A model needs a stock; add another one first</source>
        <translation>模型需要一种材料；请先添加另一种</translation>
    </message>
    <message>
        <source>Remove this stock</source>
        <translation>移除这种材料</translation>
    </message>
    <message>
        <source>From a file…</source>
        <translation>从文件…</translation>
    </message>
    <message>
        <source>Add a stock from a file</source>
        <translation>从文件添加材料</translation>
    </message>
    <message>
        <source>FlatFitFab models (%1)</source>
        <translation>FlatFitFab 模型 (%1)</translation>
    </message>
    <message numerus="yes">
        <source>Make its %n section(s) of</source>
        <translation>
            <numerusform>它的 %n 个插片改用</numerusform>
        </translation>
    </message>
    <message>
        <source>Add stock %1</source>
        <translation>添加材料 %1</translation>
    </message>
    <message>
        <source>Remove stock %1</source>
        <translation>移除材料 %1</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>保存…</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
</context>
<context>
    <name>fff::ui::StressCard</name>
    <message>
        <source>%1&#x202f;MPa, %2&#x202f;%</source>
        <extracomment>%1 is a stress in megapascals, %2 a number of percent</extracomment>
        <translation>%1&#x202f;MPa，%2&#x202f;%</translation>
    </message>
    <message>
        <source>In the neck</source>
        <translation>最窄处</translation>
    </message>
    <message>
        <source>At its corner</source>
        <translation>角上</translation>
    </message>
    <message>
        <source>Bent in its plane</source>
        <translation>板面内弯曲</translation>
    </message>
    <message>
        <source>Bent across the sheet</source>
        <translation>垂直板面弯曲</translation>
    </message>
    <message>
        <source>Pressed along</source>
        <translation>轴向受压</translation>
    </message>
    <message>
        <source>Pulled along</source>
        <translation>轴向受拉</translation>
    </message>
    <message>
        <source>Sheared</source>
        <translation>剪切</translation>
    </message>
    <message>
        <source>Twisted</source>
        <translation>扭转</translation>
    </message>
    <message>
        <source>So slender that it may buckle before it breaks.</source>
        <translation>细长得可能在断裂前先失稳弯折。</translation>
    </message>
    <message>
        <source>Uncertain: forces act beside the holes that it crosses.</source>
        <translation>不确定：它穿过的孔旁边有力作用。</translation>
    </message>
    <message>
        <source>A rough figure: the neck is too short, or too near a force.</source>
        <translation>粗略值：最窄处太短，或离力太近。</translation>
    </message>
    <message>
        <source>It would crack at its corner first.</source>
        <translation>会先从角上开裂。</translation>
    </message>
    <message>
        <source>It would break straight across.</source>
        <translation>会直接横向断裂。</translation>
    </message>
    <message>
        <source>%1&#x202f;%</source>
        <extracomment>%1 is a number of percent</extracomment>
        <translation>%1&#x202f;%</translation>
    </message>
</context>
<context>
    <name>fff::ui::StressMarks</name>
    <message>
        <source>Stress</source>
        <translation>应力</translation>
    </message>
    <message>
        <source>Safety factor %1</source>
        <extracomment>in the legend of stress: %1 is the safety factor, such as 2</extracomment>
        <translation>安全系数 %1</translation>
    </message>
    <message>
        <source>Strength unknown</source>
        <translation>强度未知</translation>
    </message>
    <message>
        <source>Nothing above %1&#x202f;%</source>
        <extracomment>%1 is a number of percent</extracomment>
        <translation>没有超过 %1&#x202f;% 的</translation>
    </message>
    <message>
        <source>%1&#x202f;%</source>
        <extracomment>%1 is a number of percent</extracomment>
        <translation>%1&#x202f;%</translation>
    </message>
    <message>
        <source>Movement %1&#x202f;×</source>
        <extracomment>%1 is a number of times</extracomment>
        <translation>位移 %1&#x202f;×</translation>
    </message>
    <message>
        <source>It does not stand; no stress is shown.</source>
        <translation>它站不稳；不显示应力。</translation>
    </message>
    <message>
        <source>A joint is pulled open; no stress is shown.</source>
        <translation>有接头被拉开；不显示应力。</translation>
    </message>
    <message>
        <source>Whether it holds could not be worked out.</source>
        <translation>无法算出是否撑得住。</translation>
    </message>
</context>
<context>
    <name>fff::ui::TemplateMaker</name>
    <message>
        <source>Looking for sections…</source>
        <translation>正在寻找插片…</translation>
    </message>
    <message>
        <source>Making facets…</source>
        <translation>正在生成面片…</translation>
    </message>
    <message>
        <source>Unfolding…</source>
        <translation>正在展开…</translation>
    </message>
    <message>
        <source>Tracing %1…</source>
        <translation>正在描摹 %1…</translation>
    </message>
    <message numerus="yes">
        <source>Made %n section(s).</source>
        <translation>
            <numerusform>已生成 %n 个插片。</numerusform>
        </translation>
    </message>
    <message>
        <source>Select the section to cut holes in first, or place the drawing on it.</source>
        <translation>请先选中要切孔的插片，或把图放在它上面。</translation>
    </message>
    <message>
        <source>Select the section to engrave first, or place the drawing on it.</source>
        <translation>请先选中要雕刻的插片，或把图放在它上面。</translation>
    </message>
    <message>
        <source>Looking for planes…</source>
        <translation>正在寻找平面…</translation>
    </message>
</context>
<context>
    <name>fff::ui::TemplateSource</name>
    <message>
        <source>Its file</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>缺失</translation>
    </message>
    <message>
        <source>read each time</source>
        <translation>每次读取</translation>
    </message>
    <message>
        <source>kept in the model</source>
        <translation>保存在模型中</translation>
    </message>
    <message>
        <source>Find its file…</source>
        <translation>查找文件…</translation>
    </message>
    <message>
        <source>Read it from where its file is now; it lies where it lay</source>
        <translation>从文件现在的位置读取；它仍在原处</translation>
    </message>
    <message>
        <source>Link to its file…</source>
        <translation>链接到文件…</translation>
    </message>
    <message>
        <source>Leave it out of the model&apos;s file, which gets smaller, and read it from where it is each time</source>
        <translation>不放进模型文件（文件变小），每次从原位置读取</translation>
    </message>
    <message>
        <source>Keep it in the model</source>
        <translation>保存到模型中</translation>
    </message>
    <message>
        <source>Put it into the model&apos;s file, so that it is there on other computers</source>
        <translation>放进模型文件，这样在其他电脑上也有</translation>
    </message>
</context>
<context>
    <name>fff::ui::TemplateTools</name>
    <message>
        <source>Move, turn and scale it in the view, with handles or numbers</source>
        <translation>在视图中用手柄或数字移动、转动和缩放它</translation>
    </message>
    <message>
        <source>Size by a line</source>
        <translation>按线缩放</translation>
    </message>
    <message>
        <source>Draw a line over something in it whose length you know</source>
        <translation>在它里面已知长度的地方画一条线</translation>
    </message>
    <message>
        <source>Move and turn</source>
        <translation>移动和旋转</translation>
    </message>
</context>
<context>
    <name>fff::ui::TemplatesDock</name>
    <message>
        <source>Templates</source>
        <translation>参考物</translation>
    </message>
    <message>
        <source>Add template…</source>
        <translation>添加参考物…</translation>
    </message>
    <message>
        <source>Read a mesh, a picture or a drawing to draw sections after it</source>
        <translation>读入网格、图片或图稿，照着它画插片</translation>
    </message>
    <message>
        <source>Add a mesh, a picture or a drawing, or drop or paste one. Sections that you draw snap to where their planes cut a mesh, and to the lines of a drawing in their plane.</source>
        <translation>添加网格、图片或图稿，也可以拖入或粘贴。你画的插片会吸附到所在平面与网格的截线，以及该平面内图稿的线条。</translation>
    </message>
    <message>
        <source>F2 renames, Space hides, L locks, Del removes.</source>
        <translation>F2 重命名，空格键隐藏，L 锁定，Del 移除。</translation>
    </message>
    <message>
        <source>Slices…</source>
        <translation>切片…</translation>
    </message>
    <message>
        <source>Cut it into sections that follow it</source>
        <translation>把它切成贴合其形状的插片</translation>
    </message>
    <message>
        <source>Place and size</source>
        <translation>位置和大小</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>不透明度</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大小</translation>
    </message>
    <message>
        <source>Extent</source>
        <translation>外形尺寸</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>To the ground</source>
        <translation>放到地面</translation>
    </message>
    <message>
        <source>Stand it on the ground</source>
        <translation>把它放到地面上</translation>
    </message>
    <message>
        <source>Stand upright</source>
        <translation>竖起来</translation>
    </message>
    <message>
        <source>Lay it on its other side: what is up in it is up in the view</source>
        <translation>把它翻倒一面：它自身的上方变成视图中的上方</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>%1 is a name, %2 what it is</extracomment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>%1 is missing</source>
        <translation>缺少 %1</translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>解锁</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>锁定</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>显示</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>隐藏</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>X of its middle</source>
        <translation>中心 X</translation>
    </message>
    <message>
        <source>Y of its middle</source>
        <translation>中心 Y</translation>
    </message>
    <message>
        <source>Z of its middle</source>
        <translation>中心 Z</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>转动</translation>
    </message>
    <message>
        <source>Turned about X, first</source>
        <translation>绕 X 转动，最先</translation>
    </message>
    <message>
        <source>Turned about Y, after X</source>
        <translation>绕 Y 转动，在 X 之后</translation>
    </message>
    <message>
        <source>Turned about Z, last</source>
        <translation>绕 Z 转动，最后</translation>
    </message>
    <message numerus="yes">
        <source>Mesh, %n triangle(s)</source>
        <translation>
            <numerusform>网格，%n 个三角形</numerusform>
        </translation>
    </message>
    <message>
        <source>Picture, %1 × %2 pixels</source>
        <extracomment>%1 and %2 are numbers of pixels</extracomment>
        <translation>图片，%1 × %2 像素</translation>
    </message>
    <message numerus="yes">
        <source>Drawing, %n line(s)</source>
        <translation>
            <numerusform>图形，%n 条线</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fff::ui::ThicknessField</name>
    <message>
        <source>Thickness</source>
        <translation>厚度</translation>
    </message>
</context>
<context>
    <name>fff::ui::TourCard</name>
    <message>
        <source>Skip this step</source>
        <translation>跳过这一步</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>End the tour</source>
        <translation>结束导览</translation>
    </message>
    <message>
        <source>Tour</source>
        <extracomment>%1 is the number of a step, %2 how many there are</extracomment>
        <translation>导览</translation>
    </message>
    <message>
        <source>Tour, step %1 of %2</source>
        <translation>导览，第 %1 步，共 %2 步</translation>
    </message>
</context>
<context>
    <name>fff::ui::TourGuide</name>
    <message>
        <source>&lt;b&gt;Look around.&lt;/b&gt; Drag beside the model to turn it; roll the wheel to come nearer.</source>
        <translation>&lt;b&gt;四处看看。&lt;/b&gt;在模型旁边拖动可以转动它；滚动滚轮可以靠近。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Cut it.&lt;/b&gt; &lt;b&gt;Export…&lt;/b&gt; shows the sheets and writes the file for the cutter.</source>
        <translation>&lt;b&gt;切出来。&lt;/b&gt;&lt;b&gt;导出…&lt;/b&gt;会显示板材，并写出切割机用的文件。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Draw a body.&lt;/b&gt; Press in the middle of the view and draw its outline in one go, flat along the top, down to the ground.</source>
        <translation>&lt;b&gt;画一个身体。&lt;/b&gt;在视图中间按下，一笔画出轮廓，上面要平，一直到地面。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Draw a section across it.&lt;/b&gt; Press inside the body and drag out across its edge. Keep the button down: the view turns. Then draw the outline, down to the ground again.</source>
        <translation>&lt;b&gt;画一个横穿它的插片。&lt;/b&gt;在身体里面按下，拖过边缘到外面。不要松开：视图会转过来。接着画出轮廓，同样到地面。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Measure your sheet.&lt;/b&gt; Click the stock at the right of the tool bar, then its thickness, and type what you measured: all slits follow.</source>
        <translation>&lt;b&gt;量一量你的板材。&lt;/b&gt;点击工具栏右侧的材料，再点击厚度，输入量到的数值：所有插槽都会跟着变。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Will it work?&lt;/b&gt; The badges over the view tell you. Click one to read more.</source>
        <translation>&lt;b&gt;行得通吗？&lt;/b&gt;视图上方的标签会告诉你。点击其中一个可以了解更多。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Repeat it.&lt;/b&gt; Choose &lt;b&gt;Linear&lt;/b&gt;, click the section that you drew across, then the body: copies stand in a row along it.</source>
        <translation>&lt;b&gt;重复它。&lt;/b&gt;选择&lt;b&gt;成排&lt;/b&gt;，点击横穿的插片，再点击身体：副本沿着身体排成一排。</translation>
    </message>
    <message>
        <source>&lt;b&gt;That was all of the way,&lt;/b&gt; from the first stroke to the file. What is red has links under Checks that fix it. Press &lt;b&gt;F1&lt;/b&gt; for more.</source>
        <translation>&lt;b&gt;全程就是这样，&lt;/b&gt;从第一笔到文件。红色的问题在“检查”里有链接可以修好。按 &lt;b&gt;F1&lt;/b&gt; 了解更多。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Nearly.&lt;/b&gt; Drag the round handle at the end of the row back until no badge is red; then &lt;b&gt;Export…&lt;/b&gt; writes the file for the cutter.</source>
        <translation>&lt;b&gt;差一点。&lt;/b&gt;把这一排末端的圆形手柄往回拖，直到没有红色标签；然后用&lt;b&gt;导出…&lt;/b&gt;写出切割机用的文件。</translation>
    </message>
    <message>
        <source>&lt;b&gt;That one is very small.&lt;/b&gt; Undo it, then draw it larger, about half as wide as the view.</source>
        <translation>&lt;b&gt;这个太小了。&lt;/b&gt;请撤销，再画大一些，宽度约为视图的一半。</translation>
    </message>
    <message>
        <source>&lt;b&gt;The tour ends here.&lt;/b&gt; You can take it again from the &lt;b&gt;Help&lt;/b&gt; menu. Press &lt;b&gt;F1&lt;/b&gt; for more.</source>
        <translation>&lt;b&gt;导览到此结束。&lt;/b&gt;可以从&lt;b&gt;帮助&lt;/b&gt;菜单再次开始。按 &lt;b&gt;F1&lt;/b&gt; 了解更多。</translation>
    </message>
</context>
<context>
    <name>fff::ui::UnsavedWork</name>
    <message>
        <source>Unsaved work cannot be backed up in case of a crash. Save it to be safe.</source>
        <translation>未保存的内容无法备份以防崩溃。为安全起见，请保存。</translation>
    </message>
    <message>
        <source>This work was opened or discarded in another window.</source>
        <translation>这份内容已在另一个窗口中打开或丢弃。</translation>
    </message>
    <message>
        <source>The backup could not be opened: %1.</source>
        <translation>无法打开备份：%1。</translation>
    </message>
    <message>
        <source>untitled</source>
        <translation>未命名</translation>
    </message>
    <message>
        <source>%1, %2, %3</source>
        <extracomment>%1 is a model&apos;s name, %2 how many steps, %3 when: &quot;untitled, 14 steps, 2 minutes ago&quot;</extracomment>
        <translation>%1，%2，%3</translation>
    </message>
    <message numerus="yes">
        <source>%n step(s)</source>
        <translation>
            <numerusform>%n 步</numerusform>
        </translation>
    </message>
    <message>
        <source>A copy of unsaved work was made by a newer FlatFitFab; it is kept as %1.</source>
        <translation>有一份未保存内容的副本是由更新版本的 FlatFitFab 生成的；已保留为 %1。</translation>
    </message>
    <message>
        <source>A copy of unsaved work could not be read; it is kept as %1.</source>
        <translation>有一份未保存内容的副本无法读取；已保留为 %1。</translation>
    </message>
</context>
<context>
    <name>fff::ui::ValueDetails</name>
    <message>
        <source>Length</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>Whole number</source>
        <translation>整数</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>质量</translation>
    </message>
    <message>
        <source>Ratio</source>
        <translation>比例</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>数字</translation>
    </message>
    <message>
        <source>Yes or no</source>
        <translation>是或否</translation>
    </message>
    <message>
        <source>Choice</source>
        <translation>选项</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>文字</translation>
    </message>
    <message>
        <source>small</source>
        <translation>小</translation>
    </message>
    <message>
        <source>large</source>
        <translation>大</translation>
    </message>
    <message>
        <source>Choices</source>
        <translation>可选项</translation>
    </message>
    <message>
        <source>small | large</source>
        <comment>an example of choices</comment>
        <translation>小 | 大</translation>
    </message>
    <message>
        <source>Made of</source>
        <translation>由什么得出</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>分组</translation>
    </message>
    <message>
        <source>heading above it</source>
        <translation>它上方的标题</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>what it is for</source>
        <translation>它的用途</translation>
    </message>
    <message>
        <source>This cannot be read as what is needed here.</source>
        <translation>这无法识别为这里所需的内容。</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>Minimum</source>
        <translation>最小值</translation>
    </message>
    <message>
        <source>any</source>
        <translation>任意</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>最大值</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>步长</translation>
    </message>
    <message>
        <source>Others can adjust it</source>
        <translation>别人可以调整</translation>
    </message>
    <message>
        <source>It can be set where the design is shared for adjusting</source>
        <translation>设计交给别人调整时，可以设置它</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>What is made of it becomes plain numbers</source>
        <translation>由它构成的内容会变成普通数字</translation>
    </message>
</context>
<context>
    <name>fff::ui::ValueEditor</name>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
</context>
<context>
    <name>fff::ui::ValueRow</name>
    <message>
        <source>Name of the value</source>
        <translation>参数的名称</translation>
    </message>
    <message>
        <source>Kind, range and note</source>
        <translation>类型、范围和备注</translation>
    </message>
</context>
<context>
    <name>fff::ui::ValueRows</name>
    <message>
        <source>Only for you</source>
        <translation>只给你自己</translation>
    </message>
</context>
<context>
    <name>fff::ui::ValueTrialRows</name>
    <message>
        <source>The range is narrower now of: %1.</source>
        <extracomment>%1 are names of values: &quot;width, boards&quot;</extracomment>
        <translation>已收窄这些参数的范围：%1。</translation>
    </message>
    <message numerus="yes">
        <source>All %n variant(s) that were tried are good.</source>
        <translation>
            <numerusform>试过的 %n 个变体全部都好。</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <extracomment>%1 is what is wrong, such as &quot;Falls over&quot;, %2 in how many places it is</extracomment>
        <translation>%1（%2）</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n variant(s) fail: %2.</source>
        <extracomment>%1 is a number, %2 a list such as &quot;Falls over (5), Breaks (2)&quot;</extracomment>
        <translation>
            <numerusform>%n 个变体中有 %1 个不行：%2。</numerusform>
        </translation>
    </message>
    <message>
        <source>Of %1 corners %2 were tried.</source>
        <translation>%1 个端点组合中试了 %2 个。</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <extracomment>%1 is the name of a value, %2 what it is: &quot;width 400 mm&quot;</extracomment>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>%1 is &quot;width 400 mm, boards 6&quot;, %2 what is wrong there</extracomment>
        <translation>%1：%2</translation>
    </message>
    <message numerus="yes">
        <source>and %n other(s)</source>
        <translation>
            <numerusform>和另外 %n 个</numerusform>
        </translation>
    </message>
    <message>
        <source>Trying the ranges… %1 %</source>
        <translation>正在试遍范围… %1 %</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>重试</translation>
    </message>
    <message>
        <source>Try all ranges</source>
        <translation>试遍所有范围</translation>
    </message>
    <message>
        <source>Narrow the ranges</source>
        <translation>收窄范围</translation>
    </message>
    <message>
        <source>Says where in the ranges of the shown values the model cannot be assembled, breaks, falls over or does not fit.</source>
        <translation>指出在公开参数的范围内，模型在哪里无法拼装、会断裂、会翻倒或放不下。</translation>
    </message>
</context>
<context>
    <name>fff::ui::ValuesDock</name>
    <message>
        <source>Values</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>New value</source>
        <translation>新建参数</translation>
    </message>
    <message>
        <source>value</source>
        <extracomment>the name of a new value, one word of letters</extracomment>
        <translation>参数</translation>
    </message>
    <message>
        <source>This design is made to be adjusted: set its values, then export it. Drag in the view to turn it.</source>
        <translation>这个设计供你调整：设置它的参数，然后导出。在视图中拖动可转动它。</translation>
    </message>
    <message>
        <source>It is cut from %1.</source>
        <translation>它用 %1 切割。</translation>
    </message>
    <message>
        <source>There is nothing to adjust in this design.</source>
        <translation>这个设计没有可调整的内容。</translation>
    </message>
    <message>
        <source>Edit the design</source>
        <translation>编辑设计</translation>
    </message>
    <message>
        <source>Share for adjusting</source>
        <translation>交给别人调整</translation>
    </message>
    <message>
        <source>Bring back drawing and all panels; when it is saved now, the file opens like that.</source>
        <translation>恢复绘图和所有面板；现在保存的话，以后打开文件也是这样。</translation>
    </message>
    <message>
        <source>Whoever opens the saved model sees the view, the shown values and Export, and nothing else.</source>
        <translation>别人打开保存的模型时，只会看到视图、公开的参数和导出，没有其他。</translation>
    </message>
    <message>
        <source>Give a number a name: any field can use it, also in sums such as = 2*gap.</source>
        <translation>给数值起个名字：任何输入框都能用它，也能用在 = 2*间隙 这样的算式里。</translation>
    </message>
</context>
<context>
    <name>fff::ui::ViewChips</name>
    <message>
        <source>How the model is shown</source>
        <translation>模型的显示方式</translation>
    </message>
    <message>
        <source>X-ray</source>
        <translation>X 光</translation>
    </message>
    <message>
        <source>Click to see the sections as they are again.</source>
        <translation>点击恢复插片原来的样子。</translation>
    </message>
    <message>
        <source>Cut open</source>
        <translation>剖开</translation>
    </message>
    <message>
        <source>Click to see the whole model again.</source>
        <translation>点击恢复显示整个模型。</translation>
    </message>
</context>
<context>
    <name>fff::ui::ViewCube</name>
    <message>
        <source>TOP</source>
        <comment>a face of the view cube: short</comment>
        <translation>上</translation>
    </message>
    <message>
        <source>BOTTOM</source>
        <comment>a face of the view cube: short</comment>
        <translation>下</translation>
    </message>
    <message>
        <source>FRONT</source>
        <comment>a face of the view cube: short</comment>
        <translation>前</translation>
    </message>
    <message>
        <source>BACK</source>
        <comment>a face of the view cube: short</comment>
        <translation>后</translation>
    </message>
    <message>
        <source>RIGHT</source>
        <comment>a face of the view cube: short</comment>
        <translation>右</translation>
    </message>
    <message>
        <source>LEFT</source>
        <comment>a face of the view cube: short</comment>
        <translation>左</translation>
    </message>
</context>
<context>
    <name>fff::ui::Viewport</name>
    <message>
        <source>View of the model</source>
        <translation>模型视图</translation>
    </message>
    <message>
        <source>Draw with the left mouse button, turn with the right one.</source>
        <translation>用鼠标左键画，右键转动。</translation>
    </message>
</context>
<context>
    <name>fff::ui::Workshop</name>
    <message>
        <source>%1 for the workshop</source>
        <extracomment>%1 is a model&apos;s name: what a folder of its files for a workshop is called</extracomment>
        <translation>%1 加工文件</translation>
    </message>
    <message>
        <source>The steps are not among the files: %1</source>
        <extracomment>%1 is a sentence</extracomment>
        <translation>文件中不含步骤：%1</translation>
    </message>
    <message>
        <source>Where to put the folder “%1”</source>
        <translation>把文件夹“%1”放在哪里</translation>
    </message>
    <message>
        <source>Put it here</source>
        <translation>放在这里</translation>
    </message>
    <message>
        <source>no picture can be made on this display.</source>
        <translation>在这台显示设备上无法生成图片。</translation>
    </message>
</context>
<context>
    <name>main</name>
    <message>
        <source>Draws flat parts in 3D and cuts them.</source>
        <translation>在 3D 中画平板零件并切割出来。</translation>
    </message>
    <message>
        <source>Models to open, each in a window; drawings, meshes and pictures to add to a new one.</source>
        <translation>要打开的模型，每个一个窗口；图稿、网格和图片则加到新模型中。</translation>
    </message>
    <message>
        <source>Opens FILE as a copy: saving asks for a name.</source>
        <translation>把 FILE 作为副本打开：保存时会询问名称。</translation>
    </message>
    <message>
        <source>Plays a script of presses and moves.</source>
        <translation>播放按键和移动的脚本。</translation>
    </message>
    <message>
        <source>SCRIPT</source>
        <translation>脚本</translation>
    </message>
    <message>
        <source>Starts without what was set, and keeps no settings.</source>
        <translation>启动时不用已有设置，也不保留任何设置。</translation>
    </message>
</context>
</TS>
